#include "frame.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 light;   // how much sky and sun the rocks leave
out vec3 world;
out vec3 upright;
out vec2 reached;

void main() {
    world = position;
    upright = normal;
    reached = light;
    gl_Position = view_projection * vec4(position, 1.);
}
