// What a rock takes from the light of the sand about it; water between softens it, and so does distance.
#include "frame.glsl"
in vec3 world;
in float dark;
out vec4 colour;

void main() {
    float far = length(world - eye.xyz);
    float left = exp(-.09 * far * 22. / water.x) * (1. - smoothstep(9., 13., far));
    colour = vec4(0., 0., 0., dark * left);
}
