// One triangle that covers the target, at the far plane: it draws only where nothing nearer was drawn.
#include "frame.glsl"
out vec3 ray;

void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 3. : -1., gl_VertexID == 2 ? 3. : -1.);
    ray = forward.xyz + corner.x * right.w * right.xyz + corner.y * up.w * up.xyz;
    gl_Position = vec4(corner, 1., 1.);
}
