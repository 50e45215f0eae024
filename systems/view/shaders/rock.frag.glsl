// Rock: grey stone under green algae and pink coralline crust, mottled from three sides; dark where it meets the sand.
#include "water.glsl"
uniform sampler2D surface_map;   // rg slopes, b height, a clouds: waves of water carve a good stone, too
in vec3 world;
in vec3 upright;
in float over;
out vec4 colour;

void main() {
    vec3 smooth_normal = normalize(upright);
    vec3 weight = smooth_normal * smooth_normal;
    weight *= weight;
    weight /= weight.x + weight.y + weight.z;
    vec4 from_x = texture(surface_map, world.yz * .19);
    vec4 from_y = texture(surface_map, world.xz * .19 + .31);
    vec4 from_z = texture(surface_map, world.xy * .19 + .67);
    float mottle = dot(weight, vec3(from_x.a, from_y.a, from_z.a));
    float patch_of = texture(water_map, world.xy * .105 + world.z * vec2(.075, -.05)).b;
    float grain = dot(weight, vec3(from_x.b, from_y.b, from_z.b)) - .5;
    vec3 bump = weight.x * vec3(0., from_x.rg - .5) + weight.y * vec3(from_y.r - .5, 0., from_y.g - .5)
              + weight.z * vec3(from_z.rg - .5, 0.);
    vec3 normal = normalize(smooth_normal - 1.5 * bump);

    vec3 stone = mix(vec3(.26, .28, .25), vec3(.66, .66, .58), mottle);
    vec3 algae = mix(vec3(.14, .26, .13), vec3(.52, .64, .36), mottle);
    vec3 crust = mix(vec3(.34, .16, .28), vec3(.74, .48, .60), mottle);
    float up_side = .5 + .5 * smooth_normal.z;
    vec3 skin = mix(stone, algae, smoothstep(.36, .56, mottle * .55 + up_side * .28 + patch_of * .2));
    skin = mix(skin, crust, smoothstep(.54, .66, patch_of * .8 + (mottle - .5) * .55 + .08 * (1. - up_side)));
    skin *= 1. + 1.1 * grain;

    float clear = smoothstep(-.05, .5, over);
    vec2 reached = vec2(.4 + .95 * clear, .45 + .55 * clear);
    colour = vec4(graded(through_water(skin * sunlight_in(world, normal, reached), world)), 1.);
}
