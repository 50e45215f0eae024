// Light in water, for every fragment shader (FINDINGS 8, Look): what falls on a surface, what water does to it on the
// way to the eye, and how the sum becomes a colour of the screen. Colours are linear until graded() is called last.
#include "frame.glsl"
#include "film.glsl"

uniform sampler2D water_map;   // r caustic net, g shafts, b soft noise, a fine noise

const float CLEAR = 22.;                        // [m] of visibility to which the numbers below belong
const vec3 ABSORB = vec3(.078, .036, .030);     // [1/m]
const float SCATTER = .050;                     // [1/m]
const vec3 AHEAD = vec3(.004, .074, .152);     // what water scatters to the eye along the horizon
const vec3 ABOVE = vec3(.030, .230, .310);     // ... looking up
const vec3 BELOW = vec3(.002, .030, .085);      // ... looking down
const vec3 SUN_COLOUR = vec3(1.22, 1.12, .93);
const vec3 SKY_COLOUR = vec3(.17, .33, .36);
const vec3 SHAFT_COLOUR = vec3(.16, .45, .52);

// A colour as artists give it (sRGB) in linear light.
vec3 linear(vec3 colour) { return colour * colour; }

// The net of light under a wavy surface, about 0 to 1.6, at a point of the world.
float caustics(vec3 world) {
    vec2 at = world.xy - sun.xy / sun.z * world.z;
    float time = eye.w;
    vec2 bend = .03 * sin(at.yx * .9 + time * vec2(.7, .6));
    float a = texture(water_map, at * .165 + bend + time * vec2(.011, .007)).r;
    float b = texture(water_map, at.yx * vec2(-.205, .205) + bend - time * vec2(.009, .012)).r;
    return 1.9 * min(a, b) + .9 * a * b;
}

// Light on a surface of unit `normal` to which `reached` of the sky (x) and of the sun (y) come, 0 to 1.
vec3 sunlight_in(vec3 world, vec3 normal, vec2 reached) {
    float depth = max(-world.z, 0.);
    vec3 left = exp(-.55 * ABSORB * depth * (CLEAR / water.x));
    float facing = max(dot(normal, sun.xyz), 0.);
    vec3 way = world - eye.xyz;
    float clear = water.y * (1. - .5 * smoothstep(6., 30., depth)) * smoothstep(.05, .75, normal.z);
    clear /= 1. + .0007 * dot(way, way);
#ifndef LOW
    clear *= .45 + .9 * texture(water_map, world.xy * .037 + eye.w * .004).b;
#endif
    float net = mix(.62, caustics(world), clear);
    vec3 sky = mix(vec3(.07, .13, .12), SKY_COLOUR, .5 + .5 * normal.z);
    return left * (SUN_COLOUR * sun.w * facing * reached.y * (.24 + .86 * net) + sky * reached.x);
}

// Light on an open surface of unit `normal`: sun with caustics, sky, and what the sand throws back.
vec3 sunlight(vec3 world, vec3 normal) { return sunlight_in(world, normal, vec2(1.)); }

// Brightness of the shafts of light between the eye and `reach` [m] along the unit `direction`: the ray crosses three
// cylinders around the eye whose axis is the sun's, on which shafts are straight lines along that axis.
float shafts(vec3 direction, float reach) {
    float along = dot(direction, sun.xyz);
    vec3 across = direction - along * sun.xyz;
    float size = max(length(across), .02);
    vec3 side = across / size;
    vec3 axis_a = normalize(vec3(sun.z, 0., -sun.x));
    vec3 axis_b = cross(sun.xyz, axis_a);
    vec2 turn = vec2(dot(side, axis_a), dot(side, axis_b));
    vec2 here = vec2(dot(eye.xyz, axis_a), dot(eye.xyz, axis_b));
    float time = eye.w, sum = 0.;
    vec3 radii = vec3(3.2, 7.5, 15.), weights = vec3(.45, .8, .9);
#ifdef LOW
    for (int i = 0; i < 2; i++) {
#else
    for (int i = 0; i < 3; i++) {
#endif
        float far = radii[i] / size;
        vec2 at = (here + turn * radii[i]) * .052;
        float beam = texture(water_map, at + time * vec2(.0031, -.0017)).g;
#ifndef LOW
        beam *= .4 + texture(water_map, at * 1.7 - time * vec2(.0043, .0024)).b;
#endif
        float depth = -eye.z - far * direction.z;
        float lit = exp(-.10 * max(depth, 0.)) * smoothstep(-.6, .6, depth);
        sum += weights[i] * beam * lit * exp(-.045 * far) * smoothstep(far * .8, far * 1.2, reach);
    }
    return sum;
}

// What a long way of water along the unit `direction` scatters towards the eye, without shafts.
vec3 veil(vec3 direction) {
    vec3 colour = mix(AHEAD, direction.z > 0. ? ABOVE : BELOW, smoothstep(0., .75, abs(direction.z)));
    float towards = max(dot(direction, sun.xyz), 0.);
    colour *= 1. + .9 * towards * towards * towards;
    return colour * exp(-.022 * max(-eye.z - 4., 0.));
}

// As veil(), with the shafts of light of an endless way.
vec3 inscatter(vec3 direction) {
    return veil(direction) + SHAFT_COLOUR * sun.w * shafts(direction, 1e3);
}

// `colour` of the point `world`, as it reaches the eye.
vec3 through_water(vec3 colour, vec3 world) {
    vec3 way = world - eye.xyz;
    float distance = max(length(way), 1e-3);
    vec3 direction = way / distance;
    float thick = CLEAR / water.x * distance;
    vec3 kept = exp(-ABSORB * thick);
    vec3 gained = veil(direction) * (1. - exp(-SCATTER * thick));
    // Farther than one sees, things are water.
    kept *= 1. - smoothstep(.9, 2.4, distance / water.x);
    return colour * kept + gained + SHAFT_COLOUR * sun.w * shafts(direction, distance);
}
