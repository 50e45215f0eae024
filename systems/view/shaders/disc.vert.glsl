// The oral disc of an anemone: a dome on the last node of its foot, bare around the mouth in its middle.
#include "flora.glsl"
layout(location = 0) in vec4 corner;   // part of the way from mouth to rim; turn; height over the radius; how free
layout(location = 1) in vec4 place;    // middle [m], w radius [m]
layout(location = 2) in vec4 side;     // w radius of what is bare over the disc's
layout(location = 3) in vec4 ahead;    // w look
layout(location = 4) in vec4 set;      // chance, sky and sun that reach it, height of the dome over the radius

const float MOUTH = .34;   // of what is bare

void main() {
    Part part = look_of(ahead.w, set.x);
    if (corner.x < -.1) part.root *= .22;
    float angle = 6.2831853 * corner.y, out_to = mix(MOUTH * side.w, 1., corner.x);
    vec3 over = cross(ahead.xyz, side.xyz), out_of = cos(angle) * side.xyz + sin(angle) * over;
    // Folds run from the mouth to the rim.
    float inside = smoothstep(0., .3, corner.x) * (1. - smoothstep(.8, 1., corner.x));
    float fold = .012 * cos(32. * angle) * inside;
    float height = set.w * (1. - min(out_to * out_to, 1.)) + corner.z + fold;
    vec3 world = place.xyz + place.w * (max(out_to, 0.) * out_of + height * ahead.xyz);
    float steep = corner.x > 1. ? 1.5 : corner.x < .05 ? -.6 : 2. * set.w * out_to;
    vec3 upright = normalize(ahead.xyz + steep * out_of + .35 * inside * sin(32. * angle) * cross(ahead.xyz, out_of));
    float around = 2. * max(floor(part.pattern.w + .5), 3.);
    show(part, world, upright, clamp(corner.x, 0., 1.), corner.y * around, corner.w, set.yz, 0.);
}
