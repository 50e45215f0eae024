// Sand: ripples as a bent normal, patches of colour, small pebbles, caustics.
#include "water.glsl"
uniform sampler2D relief_map;   // rg slopes, b pebbles, a mottling
in vec3 world;
in vec3 upright;
in vec2 reached;
out vec4 colour;

void main() {
    float far = length(world - eye.xyz);
    float detail = 1. / (1. + .004 * far * far);
    vec4 fine = texture(relief_map, world.xy * .22);
    vec4 wide = texture(relief_map, world.yx * .031 + .37);
    vec2 slope = (fine.rg - .5) * .75 * detail + (wide.gr - .5) * .85;
    vec3 normal = normalize(upright + vec3(-slope, 0.));
    vec3 sand = mix(vec3(.50, .47, .38), vec3(.80, .76, .62), wide.a);
    sand *= .82 + .36 * fine.a;
    sand *= mix(1., .45 + 1.1 * fine.b, detail);
#ifndef LOW
    vec4 grain = texture(relief_map, world.xy * 1.7);
    float near = 1. / (1. + .06 * far * far);
    sand *= 1. + near * (.55 * (grain.a - .5) + .5 * (grain.b - .5));
    normal = normalize(normal - vec3(grain.rg - .5, 0.) * .35 * near);
#endif
    vec3 lit = sunlight_in(world, normal, reached);
    colour = vec4(graded(through_water(sand * lit, world)), 1.);
}
