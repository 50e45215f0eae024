// The oral disc of an anemone: a shallow dish with a mouth, on the last node of its foot.
#include "flora.glsl"
layout(location = 0) in vec4 corner;   // part of the way from mouth to rim; turn; height over the radius; how dark
layout(location = 1) in vec4 place;    // middle [m], w radius [m]
layout(location = 2) in vec4 side;     // w radius of the mouth over the disc's
layout(location = 3) in vec4 ahead;    // w look
layout(location = 4) in vec4 set;      // chance, sky and sun that reach it, dome

void main() {
    take_look(ahead.w, set.x, set.y, place.xyz);
    float angle = 6.2831853 * corner.y, out_to = mix(side.w, 1., corner.x);
    vec3 over = cross(ahead.xyz, side.xyz), out_of = cos(angle) * side.xyz + sin(angle) * over;
    // Folds run from the mouth to the rim.
    float fold = .018 * cos(24. * angle) * smoothstep(0., .3, corner.x);
    float height = set.w * (1. - out_to * out_to) + corner.z + fold;
    vec3 world = place.xyz + place.w * (max(out_to, 0.) * out_of + height * ahead.xyz);
    normal = normalize(ahead.xyz + (2. * set.w * out_to + .25 * (corner.x < .1 ? -1. : 0.)) * out_of
                       + .4 * fold * 24. * sin(24. * angle) * .2 * cross(ahead.xyz, out_of));
    mark = vec4(clamp(corner.x, 0., 1.), corner.y * 2. * max(floor(pattern.w + .5), 3.), corner.w, 0.);
    take_light(world, set.z);
    gl_Position = view_projection * vec4(world, 1.);
}
