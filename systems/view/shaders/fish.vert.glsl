// A fish from its nodes: 23 nodes blended between two ticks and two motions, then weights (systems/view/fish_levels.py).
#include "frame.glsl"
layout(location = 0) in float vertex;   // of the species' table
layout(location = 1) in vec4 place;     // origin [m], w length [m]
layout(location = 2) in vec4 turn;      // quaternion from body to world axes
layout(location = 3) in vec4 shown;     // shape a tick ago, shape now, blend, weight of the warp's offset
layout(location = 4) in vec4 warp;      // shape that the warp leaves, enters; species + how far behind the left one; phase of the paired fins [rad]
layout(location = 5) in vec4 shade;     // tint, w shine + 2 * how many of GAPES steps the mouth is open

uniform sampler2D shapes;    // nodes [BL], w the shape that follows, 23 texels a shape, SHAPES_A_ROW shapes a row
uniform sampler2D weights;   // 12 texels a vertex, VERTICES_A_ROW vertices a row
uniform int vertices;        // of one species' table

out vec3 world;
out vec3 normal;
out vec2 skin_at;
flat out float skin_layer;
flat out vec4 tint;
flat out float size;         // length of the fish [m]
out float inside;            // of the mouth, 0 to 1

const float GAPES = 64.;     // as in systems/view/cull.py
#if !defined(CARD) && !defined(FINS)
const vec3 MOUTH = vec3(.085, .38, .038);   // how far back it reaches along the body, around it, how far jaws part [BL]

// Part the jaws of a body's vertex by `gape`, 0 to 1: lips up, down and forward, what lies between them back and dark.
vec3 parted(float gape) {
    vec2 at = (skin_at - .004) / vec2(.992, .480);   // BODY_BOX of fish_surface.py
    float front = clamp(1. - at.x / MOUTH.x, 0., 1.) * gape;
    float across = clamp((at.y - .5) / MOUTH.y * 2., -1., 1.);
    float hollow = 1. - across * across;
    inside = front * smoothstep(.15, .75, hollow);
    float jaw = across > 0. ? -1.25 * across : -.6 * across;
    return front * vec3(.014 * (1. - 3. * hollow), MOUTH.z * jaw, 0.);
}
#endif

ivec2 shape_at(float number) {
    int row = int(number + .5);
    return ivec2(23 * (row % SHAPES_A_ROW), row / SHAPES_A_ROW);
}

vec3 turned(vec3 v) { return v + 2. * cross(turn.xyz, cross(turn.xyz, v) + turn.w * v); }

void main() {
    int index = int(warp.z) * vertices + int(vertex + .5);
    ivec2 at = ivec2(12 * (index % VERTICES_A_ROW), index / VERTICES_A_ROW);
    ivec2 last = shape_at(shown.x), now = shape_at(shown.y), from = shape_at(warp.x), to = shape_at(warp.y);
    float part = fract(warp.z);
    ivec2 beyond = part > 0. ? shape_at(texelFetch(shapes, from, 0).w) : from;
    vec3 sum = vec3(0.), along_u = vec3(0.), along_v = vec3(0.);
    int window = int(texelFetch(weights, at, 0).a + .5);
    int first = window % 32, count = window / 32;
    skin_at = vec2(texelFetch(weights, at + ivec2(1, 0), 0).a, texelFetch(weights, at + ivec2(2, 0), 0).a);
    float kind = texelFetch(weights, at + ivec2(3, 0), 0).a;
    for (int j = 0; j < count; j++) {
        vec3 weight = texelFetch(weights, at + ivec2(j, 0), 0).xyz;
        ivec2 step = ivec2(first + j, 0);
        vec3 node = mix(texelFetch(shapes, last + step, 0).xyz, texelFetch(shapes, now + step, 0).xyz, shown.z);
        if (shown.w > 0.) {
            vec3 left = texelFetch(shapes, from + step, 0).xyz;
            if (part > 0.) left = mix(left, texelFetch(shapes, beyond + step, 0).xyz, part);
            node += shown.w * (left - texelFetch(shapes, to + step, 0).xyz);
        }
        sum += weight.x * node;
        along_u += weight.y * node;
        along_v += weight.z * node;
    }
    vec3 upright = cross(along_u, along_v);
    if (kind > 1.5) {   // a blade on its hinge; pelvic fins stay closer and move less, a shark's are wings
        float angle = kind < 2.5 ? .62 + .42 * sin(warp.w) : kind < 3.5 ? .30 + .12 * sin(.7 * warp.w + 1.) : 1.12;
        sum += cos(angle) * along_u + sin(angle) * along_v;
        upright = cos(angle) * along_v - sin(angle) * along_u;
    }
    float steps = floor(.5 * shade.w);
    inside = 0.;
#if !defined(CARD) && !defined(FINS)
    if (steps > 0.) sum += parted(steps / GAPES);
#endif
    world = place.xyz + place.w * turned(sum);
    normal = turned(upright);
    skin_layer = floor(warp.z);
    tint = vec4(shade.xyz, shade.w - 2. * steps);
    size = place.w;
    gl_Position = view_projection * vec4(world, 1.);
}
