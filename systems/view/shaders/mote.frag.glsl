in float bright;
out vec4 colour;

void main() {
    vec2 at = gl_PointCoord * 2. - 1.;
    float soft = clamp(1. - dot(at, at), 0., 1.);
    colour = vec4(vec3(.55, .80, .82) * bright * soft * soft, 0.);
}
