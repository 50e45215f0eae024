// A fibre from its rings (systems/view/fibre_strips.py): a tube with a round tip. FLAT: a blade, creased along its
// middle. RIBBON: seen so small that a strip which faces the eye serves.
#include "flora.glsl"
layout(location = 0) in vec4 corner;   // ring from the tip; turn around it; way beyond it, part of its radius left
layout(location = 1) in vec4 strip;    // first ring, rings, look, chance
layout(location = 2) in vec4 set;      // length [m], sky and sun that reach it, widening

uniform sampler2D rings;   // 3 texels a ring, RINGS_A_ROW a row: place, radius | side, way [m] | direction, slope

vec4 ring_at(int number, int part) {
    return texelFetch(rings, ivec2(3 * (number % RINGS_A_ROW) + part, number / RINGS_A_ROW), 0);
}

void main() {
    int number = int(strip.x + strip.y - 1. - corner.x + .5);
    vec4 place = ring_at(number, 0), side = ring_at(number, 1), ahead = ring_at(number, 2);
    take_look(strip.z, strip.w, set.y, place.xyz);
    float kind = root.w, way = clamp(side.w / max(set.x, 1e-4), 0., 1.), radius = place.w * set.w;
    vec3 over = cross(ahead.xyz, side.xyz);
    float open = 1.;
#if defined(RIBBON)
    float x = 2. * corner.y - 1.;
    vec3 view = normalize(eye.xyz - place.xyz);
    vec3 across = normalize(cross(ahead.xyz, view) + 1e-5 * side.xyz);
    vec3 world = place.xyz + radius * x * across;
    normal = normalize(.8 * x * across + view);
    float turn = corner.y * .5;
#elif defined(FLAT)
    float x = 2. * corner.y - 1.;
    float ruffle = kind == FROND ? .38 * x * x * sin(31. * side.w / max(12. * place.w, .02) + 3. * x + 9. * strip.w) : 0.;
    vec3 world = place.xyz + radius * (x * side.xyz + (.30 * abs(x) + ruffle) * over);
    normal = normalize(over - .55 * x * side.xyz - .9 * ruffle * sign(x) * side.xyz);
    float turn = corner.y;
#else
    float angle = 6.2831853 * corner.y;
    vec3 out_of = cos(angle) * side.xyz + sin(angle) * over;
    float beyond = corner.z * radius;
    vec3 world = place.xyz + corner.w * radius * out_of + beyond * ahead.xyz;
    normal = normalize(corner.w * (out_of - ahead.w * ahead.xyz) + corner.z * ahead.xyz);
    float turn = corner.y;
#endif
    // Deep among its like a fibre stands in their shade.
    if (kind == TENTACLE) open = mix(.30, 1., smoothstep(0., .55, way));
    else if (kind == BLADE) open = mix(.30, 1., smoothstep(0., .45, way));
    else if (kind == FOOT) open = mix(.45, 1., smoothstep(0., .6, way));
    else if (kind == FROND) open = mix(.75, 1., way);
    float around = max(floor(pattern.w * 6.2832 * place.w / max(set.x, 1e-3) + .5), 2.);
    if (tip.w > 2.5 && tip.w < 3.5) around = max(floor(pattern.w + .5), 2.);
    mark = vec4(way, turn * around, open, kind >= BLADE ? 2. * corner.y - 1. : turn);
    take_light(world, set.z);
    gl_Position = view_projection * vec4(world, 1.);
}
