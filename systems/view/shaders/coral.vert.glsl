#include "frame.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 about;   // height over the sand [m]; hollow; sky and sun that reach it
layout(location = 3) in vec2 kind;    // look; chance
out vec3 world;
out vec3 upright;
out vec4 set;
flat out vec2 head;

void main() {
    world = position;
    upright = normal;
    set = about;
    head = kind;
    gl_Position = view_projection * vec4(position, 1.);
}
