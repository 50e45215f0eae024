// The colour of the screen for linear light: filmic curve, sRGB-like gamma. Every fragment shader calls it last.
vec3 graded(vec3 light) {
    vec3 x = light * 1.05;
    vec3 film = x * (2.51 * x + .03) / (x * (2.43 * x + .59) + .14);
    return sqrt(clamp(film, 0., 1.));
}
