// What stands behind everything: open water, and above it the surface seen from below.
#include "water.glsl"
uniform sampler2D surface_map;   // rg slopes, b height, a clouds
in vec3 ray;
out vec4 colour;

// The sky through the surface, along the unit `direction` in air.
vec3 sky(vec3 direction, vec2 at) {
    float towards = max(dot(direction, normalize(vec3(sun.xy * 1.333, sqrt(max(1. - 1.777 * dot(sun.xy, sun.xy), .01))))), 0.);
    vec3 blue = mix(vec3(.75, .95, 1.), vec3(.34, .62, .80), direction.z);
    return blue + sun.w * (vec3(.5, .5, .45) * pow(towards, 8.) + vec3(14., 13., 11.) * pow(towards, 350.));
}

vec3 surface(vec3 direction) {
    float far = -eye.z / direction.z;
    vec2 at = eye.xy + direction.xy * far;
    float time = eye.w;
    vec4 large = texture(surface_map, at * .030 + time * vec2(.006, .004));
    vec4 small = texture(surface_map, at.yx * .113 - time * vec2(.013, .009));
    vec2 slope = ((large.rg - .5) * 1.1 + (small.gr - .5) * .75) * .62 * water.z;
    vec3 normal = normalize(vec3(slope, -1.));          // faces the water
    float into = max(-dot(direction, normal), .02);
    vec3 bent = refract(direction, normal, 1.333);
    vec3 back = reflect(direction, normal);
    float open = step(.25, dot(bent, bent));
    float fresnel = mix(1., .02 + .98 * pow(1. - max(-dot(bent, normal), 0.), 5.), open);
    vec3 mirrored = veil(vec3(back.xy, -abs(back.z))) * 1.15;
    vec3 seen = mix(sky(bent, at), mirrored, fresnel);
    return seen;
}

void main() {
    vec3 direction = normalize(ray);
    vec3 light;
    if (direction.z > .004) {
        float far = min(-eye.z / direction.z, 200.);
        light = through_water(surface(direction), eye.xyz + direction * far);
    } else {
        light = inscatter(direction);
    }
    colour = vec4(graded(light), 1.);
}
