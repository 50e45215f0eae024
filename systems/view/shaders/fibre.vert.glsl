// A fibre from its rings (systems/view/fibre_strips.py): a tube with a round tip. FLAT: a blade, creased along its
// middle. RIBBON: seen so small that a strip which faces the eye serves.
#include "flora.glsl"
layout(location = 0) in vec4 corner;   // ring from the tip; turn around it; way beyond it, part of its radius left
layout(location = 1) in vec4 strip;    // ring of the tip, girth [m], look, chance
layout(location = 2) in vec4 set;      // length [m], sky and sun that reach it, widening

uniform sampler2D rings;   // 3 texels a ring, RINGS_A_ROW a row: place, radius | side, way [m] | direction, slope

vec4 ring_at(int number, int part) {
    return texelFetch(rings, ivec2(3 * (number % RINGS_A_ROW) + part, number / RINGS_A_ROW), 0);
}

// How far its like leave a point free: deep among them a fibre stands in their shade.
float freedom(float kind, float way) {
    if (kind == TENTACLE) return mix(.26, 1., smoothstep(0., .6, way));
    if (kind == BLADE) return mix(.30, 1., smoothstep(0., .45, way));
    if (kind == FOOT) return mix(.40, 1., smoothstep(0., .5, way)) * mix(1., .5, smoothstep(.75, 1., way));
    if (kind == FROND) return mix(.75, 1., way);
    return 1.;
}

void main() {
    int number = int(strip.x - corner.x + .5);
    vec4 place = ring_at(number, 0), side = ring_at(number, 1), ahead = ring_at(number, 2);
    Part part = look_of(strip.z, strip.w);
    float way = clamp(side.w / max(set.x, 1e-4), 0., 1.), radius = place.w * set.w;
    vec3 over = cross(ahead.xyz, side.xyz), world, upright;
#if defined(RIBBON)
    float x = 2. * corner.y - 1., turn = .5 * corner.y;
    vec3 view = normalize(eye.xyz - place.xyz);
    vec3 across = normalize(cross(ahead.xyz, view) + 1e-5 * side.xyz);
    world = place.xyz + radius * x * across;
    upright = normalize(.8 * x * across + view);
#elif defined(FLAT)
    float x = 2. * corner.y - 1., turn = corner.y;
    float wave = 31. * side.w / max(12. * place.w, .02) + 3. * x + 9. * strip.w;
    float ruffle = part.kind == FROND ? .38 * x * x * sin(wave) : 0.;
    world = place.xyz + radius * (x * side.xyz + (.30 * abs(x) + ruffle) * over);
    upright = normalize(over - (.55 * x + .9 * ruffle * sign(x)) * side.xyz);
#else
    float angle = 6.2831853 * corner.y, turn = corner.y;
    vec3 out_of = cos(angle) * side.xyz + sin(angle) * over;
    world = place.xyz + radius * (corner.w * out_of + corner.z * ahead.xyz);
    upright = normalize(corner.w * (out_of - ahead.w * ahead.xyz) + corner.z * ahead.xyz);
#endif
    // Spots are round: as far apart around a fibre as along it. Stripes are counted around.
    float around = max(floor(part.pattern.w * strip.y / max(set.x, 1e-3) + .5), 2.);
    if (part.code == 3.) around = max(floor(part.pattern.w + .5), 2.);
    else if (part.code == 0. && part.kind >= BLADE) around = 5.;
    else if (part.code == 0. || part.code == 4. || around > 5.) around = 4. * max(floor(.25 * around + .5), 1.);
    show(part, world, upright, way, turn * around, freedom(part.kind, way), set.yz, strip.w);
}
