// A mote drifts and sways in a box that follows the eye; the box wraps, so none is ever born or dies in view.
#include "frame.glsl"
layout(location = 0) in vec4 seed;
out float bright;

const float BOX = 16.;   // [m]

void main() {
    float time = eye.w;
    vec3 drift = time * vec3(.05, .03, -.012) + .12 * sin(time * (.2 + .3 * seed.yzw) + 6.28 * seed.zwx);
    vec3 around = mod(seed.xyz * BOX + drift - eye.xyz, BOX) - .5 * BOX;
    vec3 world = eye.xyz + around;
    float far = length(around);
    gl_Position = view_projection * vec4(world, 1.);
    float size = (.004 + .016 * pow(seed.w, 5.)) * target.y / (2. * up.w * max(far, .4));
    gl_PointSize = clamp(size, 1., target.y * .016);
    bright = min(size * size, 1.) * (1. - smoothstep(.25 * BOX, .5 * BOX, far)) * smoothstep(.25, .9, far);
    bright *= step(world.z, -.1) * exp(-.03 * max(-world.z, 0.));
}
