// A fish's skin in water. FINS: membranes, seen from both sides, light shining through. CLOSE: relief is lit.
// CARD: body and fins in one pass, what is clear is cut away.
#include "water.glsl"
uniform sampler2DArray skins;

in vec3 world;
in vec3 normal;
in vec2 skin_at;
flat in float skin_layer;
flat in vec4 tint;
flat in float size;          // length of the fish [m]
in float inside;             // of the mouth, 0 to 1
out vec4 colour;

#ifdef CLOSE
// Bend the unit normal by a height [m] that is known at this pixel and its neighbours (Mikkelsen 2010).
vec3 bumped(vec3 upright, float height) {
    vec3 right_step = dFdx(world), up_step = dFdy(world);
    vec3 a = cross(up_step, upright), b = cross(upright, right_step);
    float turn = dot(right_step, a);
    vec3 slope = sign(turn) * (dFdx(height) * a + dFdy(height) * b);
    return normalize(abs(turn) * upright - slope);
}
#endif

// Light on fish: the sun wraps round a little, blue-green sky from above, a little thrown back by sand from below.
vec3 light_on(vec3 upright, vec3 towards) {
    vec3 light = sunlight(world, normalize(upright + .25 * towards));
    float left = exp(-.035 * max(-world.z, 0.)) * sun.w;
    float above = .5 + .5 * upright.z;
    vec3 around = mix(vec3(.16, .25, .27), vec3(.40, .62, .62), above * above);
    return (1.25 * light + around * left) * (.62 + .44 * abs(dot(upright, towards)));
}

// What a silvery flank mirrors: bright water above, the deep blue of the horizon, pale sand below.
vec3 mirrored_sea(vec3 direction) {
    vec3 horizon = vec3(.05, .19, .27);
    vec3 sea = direction.z > 0. ? mix(horizon, vec3(.98, 1.16, 1.16), smoothstep(.0, .8, direction.z))
                                : mix(horizon, vec3(.30, .44, .43), smoothstep(.1, .9, -direction.z));
    return sea;
}

void main() {
    vec4 skin = texture(skins, vec3(skin_at, skin_layer));
    vec3 towards = normalize(eye.xyz - world);
    vec3 upright = normalize(normal);
    vec3 albedo = linear(skin.rgb) * tint.rgb;
#ifdef FINS
    if (skin.a < .02) discard;
    upright *= sign(dot(upright, towards) + 1e-6);
    vec3 light = light_on(upright, towards);
    light += (1. - .6 * skin.a) * SUN_COLOUR * sun.w * max(dot(-upright, sun.xyz), 0.) * exp(-.02 * max(-world.z, 0.));
    float sheen = pow(max(dot(reflect(-towards, upright), sun.xyz), 0.), 12.);
    vec3 lit = albedo * light * 1.05 + tint.w * .25 * sheen;
    colour = vec4(graded(through_water(lit, world)), skin.a);
#else
#ifdef CARD
    bool fin = skin_at.y > .5;
    if (fin && skin.a < .35) discard;
    if (fin) upright *= sign(dot(upright, towards) + 1e-6);
#endif
#ifdef CLOSE
    upright = bumped(upright, skin.a * .016 * size);
#endif
    vec3 light = light_on(upright, towards);
    float facing = max(dot(upright, towards), 0.);
    vec3 mirrored = reflect(-towards, upright);
    float rim = pow(1. - facing, 4.);
    float glint = max(dot(mirrored, sun.xyz), 0.) * smoothstep(-.1, .3, dot(upright, sun.xyz));
    vec3 around = mirrored_sea(mirrored) * (light.g * .40 + .30);
    // Small on the picture a fish shows no single glint: its scales would only twinkle.
    float seen = size * target.y / (2. * up.w * length(world - eye.xyz));
    float glints = smoothstep(8., 70., seen);
    float shine = tint.w;
    vec3 film = .5 + .5 * cos(vec3(0., 1.6, 3.4) + 7. * facing + 5. * skin_at.y);   // thin layers of guanine
    shine *= 1. - inside;
    albedo = mix(albedo, vec3(.07, .018, .015), inside);
    vec3 lit = albedo * light * (1. - .74 * shine);
    lit += around * mix(vec3(.05), (.04 + 1.25 * albedo) * mix(vec3(1.), .62 + .76 * film, .6), shine) * (shine * .95 + rim * (.15 + .35 * shine));
    lit += SUN_COLOUR * sun.w * min(light.g, 1.6) * (pow(glint, 18.) * (.07 + .42 * shine) * (.35 + .65 * glints) + pow(glint, 120.) * (.22 + 1.3 * shine) * glints);
    colour = vec4(graded(through_water(lit, world)), 1.);
#endif
}
