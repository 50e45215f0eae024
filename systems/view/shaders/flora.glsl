// What grows, in light and water: reckoned once a vertex, since fibres have more corners than the sea has changes.
#include "water.glsl"
uniform sampler2D looks;   // 4 texels a look: root, kind | tip, pattern | pattern's colour, its marks | translucency

const float TENTACLE = 0., BRANCH = 1., FOOT = 2., BLADE = 3., FROND = 4., DISC = 5.;

out vec3 normal;
out vec3 towards;            // from the point to the eye [m]
out vec4 mark;               // part of the way from root to tip; turn about it, in marks; how open to light; kind's own
out vec3 sunny;              // light of the sun where it falls straight
out vec3 kept;               // part of the light that reaches the eye
out vec3 gained;             // what water adds to it on the way
flat out vec4 root;          // w kind
flat out vec4 tip;           // w pattern
flat out vec4 pattern;       // w marks of the pattern
flat out vec3 manner;        // translucency, chance, light of the sky

// Look up how a plant's part is drawn; `chance` makes each a little another.
void take_look(float look, float chance, float sky, vec3 world) {
    int row = int(look + .5);
    root = texelFetch(looks, ivec2(0, row), 0);
    tip = texelFetch(looks, ivec2(1, row), 0);
    pattern = texelFetch(looks, ivec2(2, row), 0);
    float own = fract(chance * 7.13);
    vec3 tint = (.86 + .28 * own) * mix(vec3(1.06, .98, .94), vec3(.95, 1.02, 1.05), fract(chance * 3.77));
    root.rgb *= tint;
    tip.rgb *= tint;
    manner = vec3(texelFetch(looks, ivec2(3, row), 0).x, chance, sky);
}

// What sun and water do at the point `world`, to which `reached` of the sun comes.
void take_light(vec3 world, float reached) {
    vec3 way = world - eye.xyz;
    float far = max(length(way), 1e-3), depth = max(-world.z, 0.);
    vec3 direction = way / far;
    towards = -way;
    vec3 left = exp(-.55 * ABSORB * depth * (CLEAR / water.x));
    float net = mix(.75, caustics(world), water.y * .8 / (1. + .0012 * far * far));
    sunny = left * SUN_COLOUR * sun.w * reached * (.24 + .86 * net);
    manner.z *= left.g;
    // As through_water() does.
    float thick = CLEAR / water.x * far;
    kept = exp(-ABSORB * thick) * (1. - smoothstep(.9, 2.4, far / water.x));
    gained = veil(direction) * (1. - exp(-SCATTER * thick)) + SHAFT_COLOUR * sun.w * shafts(direction, far);
}
