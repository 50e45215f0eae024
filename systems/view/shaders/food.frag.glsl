flat in vec3 light;
flat in float cover;
out vec4 colour;

void main() {
    vec2 at = gl_PointCoord * 2. - 1.;
    float inside = 1. - smoothstep(.55, 1., dot(at, at));
    // Round: lit from above, darker below.
    colour = vec4(light * (.82 - .28 * at.y), inside * cover);
}
