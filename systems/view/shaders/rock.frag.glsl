// Rock: grey stone under green algae and pink coralline crust, mottled from three sides, fine grain over coarse; dark
// where it meets the sand.
#include "water.glsl"
uniform sampler2D surface_map;   // rg slopes, b height, a clouds: what waves do to light, time does to stone
in vec3 world;
in vec3 upright;
in float over;
out vec4 colour;

struct Stone { float mottle; float grain; vec3 bump; };

// The stone's texture at `scale` repeats a metre, looked up from the three sides by `weight`.
Stone carved(vec3 weight, float scale) {
    vec3 at = world * scale;
    vec4 from_x = texture(surface_map, at.yz);
    vec4 from_y = texture(surface_map, at.xz + .31);
    vec4 from_z = texture(surface_map, at.xy + .67);
    vec4 mixed = weight.x * from_x + weight.y * from_y + weight.z * from_z;
    vec3 bump = weight.x * vec3(0., from_x.rg - .5) + weight.y * vec3(from_y.r - .5, 0., from_y.g - .5)
              + weight.z * vec3(from_z.rg - .5, 0.);
    return Stone(mixed.a, mixed.b - .5, bump);
}

void main() {
    vec3 smooth_normal = normalize(upright);
    vec3 weight = smooth_normal * smooth_normal;
    weight *= weight;
    weight /= weight.x + weight.y + weight.z;
    Stone coarse = carved(weight, .13);
#ifdef LOW
    Stone fine = coarse;
#else
    Stone fine = carved(weight, .57);
#endif
    float region = texture(water_map, world.xy * .085 + world.z * vec2(.065, -.045)).b;
    vec3 normal = normalize(smooth_normal - 1.5 * coarse.bump - .9 * fine.bump);
    float mottle = .55 * coarse.mottle + .45 * fine.mottle;
    float pale = smoothstep(.25, .75, mottle + .35 * fine.grain);

    vec3 stone = mix(vec3(.25, .27, .20), vec3(.73, .72, .55), pale);
    vec3 algae = mix(vec3(.13, .24, .10), vec3(.54, .63, .36), pale);
    vec3 crust = mix(vec3(.46, .17, .25), vec3(.98, .58, .66), pale);
    float up_side = .5 + .5 * smooth_normal.z;
    float growth = .5 * coarse.mottle + .25 * fine.mottle + .28 * up_side;
    vec3 skin = mix(stone, algae, .85 * smoothstep(.44, .62, growth));
    float crusted = .75 * region + .45 * (fine.mottle - .5) + .30 * (coarse.grain) + .10 * (1. - up_side);
    skin = mix(skin, crust, .9 * smoothstep(.45, .59, crusted));
    skin *= 1. + .7 * coarse.grain + .6 * fine.grain;

    float clear = smoothstep(-.05, .6, over);
    vec2 reached = vec2(.4 + 1.1 * clear, .4 + .6 * clear);
    colour = vec4(graded(through_water(skin * sunlight_in(world, normal, reached), world)), 1.);
}
