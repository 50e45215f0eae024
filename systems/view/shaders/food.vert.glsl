// A particle of food: a speck of plankton, lit as the sea is; a point so large as it is seen (systems/view/draw_food.py).
#include "water.glsl"
layout(location = 0) in vec4 place;   // [m], w its length [m]
layout(location = 1) in float chance;
flat out vec3 light;
flat out vec3 manner;   // cover; cosine and sine of its turn

const float LEAST = 1.7;   // [px] of a point; smaller ones grow fainter instead

void main() {
    vec3 world = place.xyz;
    gl_Position = view_projection * vec4(world, 1.);
    float distance = max(length(world - eye.xyz), .05);
    float size = place.w * target.y / (2. * up.w * distance);
    gl_PointSize = clamp(size, LEAST, target.y * .022);
    float cover = clamp(size * size / (LEAST * LEAST), 0., 1.);
    // Close to the eye all is out of focus, and fades.
    cover *= smoothstep(.15, .9, distance);
    float turn = 6.2832 * chance + .3 * sin(eye.w * (1. + chance) + 50. * chance);
    manner = vec3(cover, cos(turn), sin(turn));
    vec3 pale = mix(vec3(.88, .62, .48), vec3(.80, .80, .66), fract(chance * 13.));
    light = graded(through_water(pale * sunlight(world, vec3(0., 0., 1.)) * 1.1, world));
}
