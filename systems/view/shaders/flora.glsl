// What grows, in light and water: reckoned once a vertex, since fibres have more corners than the sea has changes. LOW
// lights the corners too.
#include "water.glsl"
#include "tissue.glsl"
uniform sampler2D looks;   // 4 texels a look: root, kind | tip, pattern | pattern's colour, its marks | translucency

const float TENTACLE = 0., BRANCH = 1., FOOT = 2., BLADE = 3., FROND = 4., DISC = 5.;

#ifdef LOW
out vec3 bare;               // what reaches the eye of unmarked skin
out vec3 marked;             // ... and of its marks
#else
out vec3 skin;
out vec3 mark_skin;
out vec3 normal;
out vec3 towards;            // from the point to the eye [m]
out vec3 sunny;              // light of the sun where it falls straight
out vec3 kept;               // part of the light that reaches the eye
out vec3 gained;             // what water adds to it on the way
out float open;              // how far neighbours leave it free
flat out vec2 manner;        // translucency, light of the sky
#endif
out vec2 mark_at;            // on the map of marks
flat out vec4 mask;          // how much of its channels

struct Part { vec3 root; vec3 tip; vec4 pattern; float kind; float code; float clear; };

// How a plant's part is drawn; `chance` makes each a little another.
Part look_of(float look, float chance) {
    int row = int(look + .5);
    vec4 a = texelFetch(looks, ivec2(0, row), 0), b = texelFetch(looks, ivec2(1, row), 0);
    float own = fract(chance * 7.13);
    vec3 tint = (.84 + .32 * own) * mix(vec3(1.07, .98, .93), vec3(.94, 1.02, 1.05), fract(chance * 3.77));
    return Part(a.rgb * tint, b.rgb * tint, texelFetch(looks, ivec2(2, row), 0), a.w, b.w, texelFetch(looks, ivec2(3, row), 0).x);
}

// Write all that the fragment shader wants of a point: `way` from root to tip, `turn` about it in marks.
void show(Part part, vec3 world, vec3 upright, float way, float turn, float free, vec2 reached, float chance) {
    vec3 from = world - eye.xyz;
    float far = max(length(from), 1e-3), depth = max(-world.z, 0.);
    vec3 direction = from / far;
    vec3 left = exp(-.55 * ABSORB * depth * (CLEAR / water.x));
    float net = mix(.75, caustics(world), water.y * .8 / (1. + .0012 * far * far));
    vec3 straight = left * SUN_COLOUR * sun.w * reached.y * (.24 + .86 * net);
    float sky = reached.x * left.g;
    // As through_water() does.
    float thick = CLEAR / water.x * far;
    vec3 through = exp(-ABSORB * thick) * (1. - smoothstep(.9, 2.4, far / water.x));
    vec3 veiled = veil(direction) * (1. - exp(-SCATTER * thick)) + SHAFT_COLOUR * sun.w * shafts(direction, far);
    vec3 own = mix(part.root, part.tip, smoothstep(.1, 1., way));
    vec3 other = part.pattern.rgb;
    bool flat_kind = part.kind == BLADE || part.kind == FROND;
    if (part.code < .5) {   // plain: veins of a blade, a little mottling of all else
        other = own * (flat_kind ? .62 : .70);
        mask = flat_kind ? vec4(0., 0., .8, .2) : vec4(0., 0., 0., .8);
    } else {
        mask = vec4(part.code < 1.5, part.code > 1.5 && part.code < 2.5, part.code > 2.5 && part.code < 3.5, part.code > 3.5);
    }
    mark_at = vec2(way * max(part.pattern.w, 1.), turn) * .25 + floor(chance * 16.) * vec2(.25, .5);
#ifdef LOW
    vec3 light, sheen;
    vec3 view = -direction;
#ifdef TWO_SIDED
    upright *= sign(dot(upright, view) + 1e-6);
#endif
    tissue(upright, view, straight, free, part.clear, sky, light, sheen);
    bare = (own * light + sheen) * through + veiled;
    marked = (other * light + sheen) * through + veiled;
#else
    skin = own;
    mark_skin = other;
    normal = upright;
    towards = -from;
    sunny = straight;
    kept = through;
    gained = veiled;
    open = free;
    manner = vec2(part.clear, sky);
#endif
    gl_Position = view_projection * vec4(world, 1.);
}
