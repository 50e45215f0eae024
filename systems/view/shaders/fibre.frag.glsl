// Living tissue in water: marks along and around it, light that shines through its rim, a wet gloss.
#include "water.glsl"
in vec3 normal;
in vec3 towards;
in vec4 mark;
in vec3 sunny;
in vec3 kept;
in vec3 gained;
flat in vec4 root;
flat in vec4 tip;
flat in vec4 pattern;
flat in vec3 manner;
out vec4 colour;

// How much of the pattern's colour a point has, 0 to 1; marks that are smaller than pixels become their mean.
float marked(vec2 at) {
    vec2 fine = fwidth(at);
    if (tip.w < .5) return 0.;
    if (tip.w < 1.5) {                                         // spots, in staggered rows
        float rank = floor(at.x);
        vec2 cell = fract(vec2(at.x, at.y + .5 * mod(rank, 2.))) - .5;
        float blur = clamp(max(fine.x, fine.y), .06, .5);
        return mix(1. - smoothstep(.30 - blur, .30 + blur, length(cell)), .28, smoothstep(.5, 1.2, max(fine.x, fine.y)));
    }
    if (tip.w < 3.5) {                                         // bands across, stripes along
        float ramp = tip.w < 2.5 ? at.x : at.y, step = tip.w < 2.5 ? fine.x : fine.y;
        float wave = abs(fract(ramp) - .5) * 2., blur = clamp(2. * step, .12, 1.);
        return mix(smoothstep(.62 - blur, .62 + blur, wave), .4, smoothstep(.5, 1.2, step));
    }
    vec2 place = vec2(at.x, at.y) * .11 + manner.y * vec2(3.1, 7.7);   // mottled
    return smoothstep(.42, .66, texture(water_map, place).b * .7 + .3 * texture(water_map, 2.7 * place).a);
}

void main() {
    vec3 view = normalize(towards);
    vec3 upright = normalize(normal);
    float clear = manner.x;
#ifdef TWO_SIDED
    upright *= sign(dot(upright, view) + 1e-6);
#endif
    float way = mark.x;
    vec3 skin = mix(root.rgb, tip.rgb, smoothstep(.15, 1., way));
    skin = mix(skin, pattern.rgb, marked(vec2(way * pattern.w, mark.y)));
#ifdef FLAT
    // Veins along a blade, its middle the strongest.
    float vein = abs(fract(mark.w * 3.5 + .5) - .5);
    skin *= .90 + .22 * vein + .16 * smoothstep(.0, .12, abs(mark.w));
#endif
    float facing = dot(upright, sun.xyz);
    float wrap = .22 + .5 * clear;
    float lit = max(facing + wrap, 0.) / (1. + wrap);
    // What shines through from behind takes the tissue's colour twice.
    float through = clear * max(-facing, 0.) * .55;
    float edge = 1. - abs(dot(upright, view));
    float rim = edge * edge * (.25 + 1.3 * clear);
    vec3 around = mix(vec3(.09, .15, .14), vec3(.26, .44, .45), .5 + .5 * upright.z) * manner.z;
    vec3 light = sunny * lit * mix(.45, 1., mark.z) + around * mark.z * 1.25;
    vec3 shown = skin * light + skin * (.35 + skin) * sunny * through * mark.z;
    shown += (skin * .8 + .10) * rim * (around * 1.1 + .20 * sunny * max(.3 + facing, 0.)) * mark.z;
    vec3 mirrored = reflect(-view, upright);
    float glint = max(dot(mirrored, sun.xyz), 0.);
    glint *= glint; glint *= glint; glint *= glint;
    shown += sunny * glint * (.10 + .10 * clear) * mark.z;
    colour = vec4(graded(shown * kept + gained), 1.);
}
