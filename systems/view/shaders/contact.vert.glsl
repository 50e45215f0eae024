#include "frame.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in float darkness;
out vec3 world;
out float dark;

void main() {
    world = position;
    dark = darkness;
    gl_Position = view_projection * vec4(position, 1.);
}
