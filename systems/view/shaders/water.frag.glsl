// What stands behind everything: open water, and above it the surface seen from below.
#include "water.glsl"
uniform sampler2D surface_map;   // rg slopes, b height, a clouds
in vec3 ray;
out vec4 colour;

// The surface where the ray of the unit `direction` meets it: windows to a bright sky that waves tear open, more of
// them overhead (Snell), mirrored deep water between, and bright veins where the swell bends light together.
vec3 surface(vec3 direction, float far) {
    vec2 at = eye.xy + direction.xy * far;
    float time = eye.w;
    vec4 large = texture(surface_map, at * vec2(.026, .034) + time * vec2(.006, .004));
    vec4 small = texture(surface_map, at.yx * .105 - time * vec2(.013, .009));
    vec2 slope = ((large.rg - .5) + (small.gr - .5) * .9) * water.z;
    float swell = .58 * large.a + .24 * small.b + .18 * small.a;
    float open = .05 + 1.15 * direction.z / (1. + .8 * direction.z) + (swell - .5) * 1.7 + .35 * dot(slope, normalize(direction.xy + .001));
    float window = smoothstep(.40, .74, open) * (.62 + .5 * small.a);
    float rim = 1. - smoothstep(0., .06 + .0012 * far, abs(open - .45));
    float vein = 1. - smoothstep(0., .13 + .001 * far, abs(small.a - .5 + .5 * (large.b - .5)));

    vec3 air = normalize(vec3(sun.xy * 1.333, sqrt(max(1. - 1.777 * dot(sun.xy, sun.xy), .01))));
    vec3 out_of = normalize(vec3(direction.xy * 1.333 + slope * .8, max(direction.z, .3)));
    float glare = max(dot(out_of, air), 0.);
    glare *= glare * glare * glare;
    float cloud = smoothstep(.30, .85, swell + .55 * (small.b - .5) + .10 * (direction.z - .5));
    vec3 sky = mix(vec3(.15, .38, .45), vec3(.74, .82, .82), cloud);
    sky += sun.w * vec3(1., .95, .85) * (.75 * glare + 10. * pow(glare, 40.));
    vec3 mirrored = veil(vec3(direction.xy, -.3 * direction.z)) * (1.15 + 2.3 * slope.x + 1.5 * slope.y);
    return mix(mirrored, sky, min(window, .95)) + vec3(.25, .42, .45) * (.30 * rim * rim + .26 * vein * vein) * (1. - .6 * window);
}

void main() {
    vec3 direction = normalize(ray);
    vec3 light;
    if (direction.z > .004) {
        float far = min(-eye.z / direction.z, 200.);
        light = through_water(surface(direction, far), eye.xyz + direction * far);
    } else {
        light = inscatter(direction);
    }
    colour = vec4(graded(light), 1.);
}
