// Living tissue in water, marked as its species is.
#include "frame.glsl"
#include "film.glsl"
#include "tissue.glsl"
uniform sampler2D mark_map;
#ifdef LOW
in vec3 bare;
in vec3 marked;
#else
in vec3 skin;
in vec3 mark_skin;
in vec3 normal;
in vec3 towards;
in vec3 sunny;
in vec3 kept;
in vec3 gained;
in float open;
flat in vec2 manner;
#endif
in vec2 mark_at;
flat in vec4 mask;
out vec4 colour;

void main() {
    float mark = dot(texture(mark_map, mark_at), mask);
#ifdef LOW
    colour = vec4(graded(mix(bare, marked, mark)), 1.);
#else
    vec3 view = normalize(towards), upright = normalize(normal), light, sheen;
#ifdef TWO_SIDED
    upright *= sign(dot(upright, view) + 1e-6);
#endif
    tissue(upright, view, sunny, open, manner.x, manner.y, light, sheen);
    vec3 shown = mix(skin, mark_skin, mark) * light + sheen;
    colour = vec4(graded(shown * kept + gained), 1.);
#endif
}
