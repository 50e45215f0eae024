#include "frame.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 about;   // height over the sand [m]; hollow (rubble: tone); sky and sun that reach it
out vec3 world;
out vec3 upright;
out vec4 set;

void main() {
    world = position;
    upright = normal;
    set = about;
    gl_Position = view_projection * vec4(position, 1.);
}
