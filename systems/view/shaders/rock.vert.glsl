#include "frame.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float height;   // [m] over the sand
out vec3 world;
out vec3 upright;
out float over;

void main() {
    world = position;
    upright = normal;
    over = height;
    gl_Position = view_projection * vec4(position, 1.);
}
