// Rock: grey stone under green algae and pink coralline crust, carved and mottled from three sides, fine over coarse;
// dark in crevices and where it meets the sand. RUBBLE: small stones and bits of shell.
#include "water.glsl"
uniform sampler2D stone_map;   // rg slopes, b height, a growth
in vec3 world;
in vec3 upright;
in vec4 set;                   // height over the sand [m]; hollow (rubble: tone); sky and sun that reach it
out vec4 colour;

struct Stone { float growth; float height; vec3 bump; };

// The stone's texture at `scale` repeats a metre, looked up from the three sides by `weight`.
Stone carved(vec3 weight, float scale) {
    vec3 at = world * scale;
    vec4 from_x = texture(stone_map, at.yz);
    vec4 from_y = texture(stone_map, at.xz + .31);
    vec4 from_z = texture(stone_map, at.xy + .67);
    vec4 mixed = weight.x * from_x + weight.y * from_y + weight.z * from_z;
    vec3 bump = weight.x * vec3(0., from_x.rg - .5) + weight.y * vec3(from_y.r - .5, 0., from_y.g - .5)
              + weight.z * vec3(from_z.rg - .5, 0.);
    return Stone(mixed.a, mixed.b - .56, bump);
}

#ifdef RUBBLE
void main() {
    vec3 normal = normalize(upright);
    float grain = texture(stone_map, world.xy * 1.3 + world.z).b;
    float tone = set.y;
    vec3 skin = mix(vec3(.36, .35, .29), vec3(.84, .77, .62), tone);
    skin = mix(skin, vec3(.62, .36, .44), smoothstep(.62, .70, fract(tone * 7.3)) * (1. - smoothstep(.80, .85, tone)));
    skin = mix(skin, vec3(.98, .94, .86), smoothstep(.85, .95, tone));
    skin *= .7 + .95 * grain;
    float clear = smoothstep(-.01, .05, set.x);
    vec2 reached = set.zw * vec2(.45 + 1.1 * clear, .5 + .6 * clear);
    colour = vec4(graded(through_water(skin * sunlight_in(world, normal, reached), world)), 1.);
}
#else
void main() {
    vec3 smooth_normal = normalize(upright);
    vec3 weight = smooth_normal * smooth_normal;
    weight *= weight;
    weight /= weight.x + weight.y + weight.z;
    Stone coarse = carved(weight, .23);
#ifdef LOW
    Stone fine = coarse;
#else
    Stone fine = carved(weight, .83);
#endif
#ifdef LOW
    float region = 1.05 - coarse.growth;
#else
    float region = texture(water_map, world.xy * .085 + world.z * vec2(.065, -.045)).b;
#endif
    vec3 normal = normalize(smooth_normal - 1.7 * coarse.bump - 1.1 * fine.bump);
    float hollow = set.y;
    float worn = clamp(.5 + .75 * coarse.height + .7 * fine.height - .35 * hollow, 0., 1.);

    vec3 stone = mix(vec3(.25, .24, .19), vec3(.86, .79, .62), worn);
    vec3 algae = mix(vec3(.15, .22, .09), vec3(.60, .68, .36), worn);
    vec3 crust = mix(vec3(.46, .15, .26), vec3(1., .60, .70), worn);
    float up_side = .5 + .5 * smooth_normal.z;
    float growth = .55 * coarse.growth + .25 * fine.growth + .30 * up_side + .10 * coarse.height;
    float crusted = .62 * region + .55 * (1. - coarse.growth) + .22 * (fine.growth - .5) + .16 * fine.height - .10 * hollow;
    vec3 skin = mix(stone, algae, .88 * smoothstep(.535, .595, growth));
    skin = mix(skin, crust, .88 * smoothstep(.615, .655, crusted));
    skin = mix(skin, vec3(.83, .80, .66), .5 * smoothstep(.64, .70, fine.growth) * up_side);

    // Light that finds its way into cracks, and under the overhang near the sand.
    float open = clamp(1. + .9 * coarse.height + .6 * fine.height, .35, 1.15) * clamp(1. - .55 * hollow, .35, 1.2);
    float clear = smoothstep(-.05, .55, set.x);
    vec2 reached = set.zw * vec2((.30 + 1.0 * clear) * open, (.45 + .55 * clear) * mix(1., open, .5));
    vec3 light = sunlight_in(world, normal, reached);
    light += vec3(.10, .125, .11) * sun.w * (.6 - .4 * normal.z) * open * exp(-.05 * max(-world.z, 0.)) / (1. + .6 * max(set.x, 0.));
    colour = vec4(graded(through_water(skin * light, world)), 1.);
}
#endif
