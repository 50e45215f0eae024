// Living tissue in light: what falls on it, what shines through it, its wet gloss.

// Light that the tissue's colour takes, and what it adds to any colour. `open` is how far neighbours leave it free,
// `clear` how much shines through, `sky` what is left of the light from above.
void tissue(vec3 upright, vec3 view, vec3 sunny, float open, float clear, float sky, out vec3 light, out vec3 sheen) {
    float facing = dot(upright, sun.xyz), wrap = .22 + .5 * clear;
    float lit = max(facing + wrap, 0.) / (1. + wrap);
    float through = clear * max(-facing, 0.) * .45;
    float edge = 1. - abs(dot(upright, view));
    float rim = edge * edge * (.25 + 1.3 * clear) * open;
    vec3 around = mix(vec3(.09, .15, .14), vec3(.26, .44, .45), .5 + .5 * upright.z) * sky;
    vec3 bright = around * 1.1 + .20 * sunny * max(.3 + facing, 0.);
    light = sunny * (lit * mix(.45, 1., open) + through * open) + around * open * 1.25 + .8 * rim * bright;
    float glint = max(dot(reflect(-view, upright), sun.xyz), 0.);
    glint *= glint; glint *= glint; glint *= glint;
    sheen = .10 * rim * bright + sunny * glint * (.10 + .10 * clear) * open;
}
