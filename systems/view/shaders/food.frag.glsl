// A krill seen through: a bent, pale body with a darker gut; so small that only its softness shows.
flat in vec3 light;
flat in vec3 manner;   // cover; cosine and sine of its turn
out vec4 colour;

void main() {
    vec2 at = gl_PointCoord * 2. - 1.;
    at = vec2(manner.y * at.x + manner.z * at.y, manner.y * at.y - manner.z * at.x);
    at.y += .34 * at.x * at.x - .12;
    float body = 1. - smoothstep(.0, 1., dot(at, at * vec2(1.15, 7.)));
    float gut = 1. - smoothstep(.0, .5, dot(at + vec2(.28, .0), (at + vec2(.28, .0)) * vec2(3., 16.)));
    colour = vec4(light * (1. - .45 * gut), manner.x * (.74 * body + .26 * gut));
}
