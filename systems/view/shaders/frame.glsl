// The uniform block of one view, as systems/view/frame.py writes it.
layout(std140) uniform Frame {
    mat4 view_projection;
    vec4 eye;      // xyz [m], w time [s]
    vec4 forward;
    vec4 right;    // w slope * aspect
    vec4 up;       // w slope: tangent of half the vertical field of view
    vec4 sun;      // xyz towards the sun, as light travels in water; w strength
    vec4 water;    // x visibility [m], y caustics, z waves, w depth of the ground [m]
    vec4 target;   // width, height, 1 / width, 1 / height
};
