// A coral head: grooves that wander over it like those of a brain, or polyps on lobes; dead stone near the sand.
#include "water.glsl"
uniform sampler2D coral_map;   // rg slopes of the grooves, b ridges, a polyps
in vec3 world;
in vec3 upright;
in vec4 set;                   // height over the sand [m]; hollow; sky and sun that reach it
flat in vec2 head;             // 0 brain, 1 lobed; chance
out vec4 colour;

void main() {
    vec3 smooth_normal = normalize(upright);
    vec3 weight = smooth_normal * smooth_normal;
    weight *= weight * weight;
    weight /= weight.x + weight.y + weight.z;
    float brain = 1. - head.x;
    float scale = mix(4.2, 1.35 + .6 * head.y, brain);
    vec3 at = world * scale;
    vec4 from_x = texture(coral_map, at.yz), from_y = texture(coral_map, at.xz + .31), from_z = texture(coral_map, at.xy + .67);
    vec4 mixed = weight.x * from_x + weight.y * from_y + weight.z * from_z;
    vec3 bump = weight.x * vec3(0., from_x.rg - .5) + weight.y * vec3(from_y.r - .5, 0., from_y.g - .5)
              + weight.z * vec3(from_z.rg - .5, 0.);
    vec3 normal = normalize(smooth_normal - bump * mix(.25, 1.9, brain));
    float ridge = mix(mixed.a, mixed.b, brain), hollow = set.y;

    // Which coral: golden, green or lilac, each with its own valleys.
    float pick = fract(head.y * 5.37);
    vec3 high = pick < .36 ? vec3(.86, .62, .24) : pick < .68 ? vec3(.62, .66, .26) : vec3(.84, .52, .66);
    vec3 low = pick < .36 ? vec3(.34, .30, .08) : pick < .68 ? vec3(.16, .30, .12) : vec3(.38, .18, .34);
    vec3 skin = mix(low, high, smoothstep(.12, .62, ridge));
    float soft = texture(water_map, world.xy * .11 + world.z * vec2(.07, -.05)).b;
    skin *= .78 + .44 * soft;
    // Lobes are pale where they grow.
    skin = mix(skin, mix(high, vec3(.95, .88, .74), .55), (1. - brain) * smoothstep(.0, .22, -hollow) * .7);
    // Near the sand the head is dead: stone under algae.
    float dead = 1. - smoothstep(.05, .34, set.x + .22 * (soft - .5));
    skin = mix(skin, mix(vec3(.24, .24, .18), vec3(.46, .42, .33), ridge), dead);

    float open = clamp(mix(.45, 1.1, smoothstep(.1, .7, ridge)) * (1. - .9 * max(hollow, 0.)), .25, 1.15);
    float clear = smoothstep(-.05, .5, set.x);
    vec2 reached = set.zw * vec2((.30 + .95 * clear) * open, (.45 + .55 * clear) * mix(1., open, .6));
    vec3 light = sunlight_in(world, normal, reached);
    light += vec3(.10, .125, .11) * sun.w * (.6 - .4 * normal.z) * open * exp(-.05 * max(-world.z, 0.)) / (1. + .6 * max(set.x, 0.));
    colour = vec4(graded(through_water(skin * light, world)), 1.);
}
