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

void main() {
    vec4 skin = texture(skins, vec3(skin_at, skin_layer));
    vec3 towards = normalize(eye.xyz - world);
    vec3 upright = normalize(normal);
    vec3 albedo = linear(skin.rgb) * tint.rgb;
#ifdef FINS
    if (skin.a < .02) discard;
    upright *= sign(dot(upright, towards) + 1e-6);
    vec3 light = sunlight(world, normalize(upright + .3 * towards));
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
    vec3 light = sunlight(world, normalize(upright + .3 * towards));
    float facing = max(dot(upright, towards), 0.);
    vec3 mirrored = reflect(-towards, upright);
    float rim = pow(1. - facing, 4.);
    float glint = max(dot(mirrored, sun.xyz), 0.);
    float sky = smoothstep(-.25, .9, mirrored.z);
    vec3 around = mix(vec3(.02, .10, .16), vec3(.62, .86, .92), sky) * (light.g * .55 + .25);
    float shine = tint.w;
    vec3 lit = albedo * light * (1. - .45 * shine);
    lit += around * mix(vec3(.06), .25 + albedo, shine) * (shine * .55 + rim * (.18 + .45 * shine));
    lit += SUN_COLOUR * sun.w * (pow(glint, 26.) * (.08 + .5 * shine) + pow(glint, 140.) * (.25 + 1.6 * shine)) * min(light.g, 1.5) * .6;
    colour = vec4(graded(through_water(lit, world)), 1.);
#endif
}
