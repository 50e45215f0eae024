// A particle of food: a soft pellet, lit as the sea is; a point so large as it is seen (systems/view/draw_food.py).
#include "water.glsl"
layout(location = 0) in vec4 place;   // [m], w its diameter [m]
flat out vec3 light;
flat out float cover;

const float LEAST = 1.6;   // [px] of a point; smaller ones grow fainter instead

void main() {
    vec3 world = place.xyz;
    gl_Position = view_projection * vec4(world, 1.);
    float distance = max(length(world - eye.xyz), .05);
    float size = place.w * target.y / (2. * up.w * distance);
    gl_PointSize = clamp(size, LEAST, target.y * .05);
    cover = clamp(size * size / (LEAST * LEAST), 0., 1.);
    cover *= smoothstep(.08, .3, distance);
    vec3 pale = vec3(.86, .70, .42);
    light = graded(through_water(pale * sunlight(world, vec3(0., 0., 1.)), world));
}
