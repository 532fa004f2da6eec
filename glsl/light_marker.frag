#version 330 core
// A bright core in a halo, added to what is behind it.
#include "shared/frame.glsl"

in vec2 across;

layout(location = 0) out vec4 colour;

void main() {
    float r = length(across);
    float core = 1.0 - smoothstep(0.26, 0.32, r);
    float halo = max(1.0 - r, 0.0);
    vec3 light = frame.light_colour;
    vec3 hue = light / max(max(light.r, light.g), max(light.b, 1e-6));
    colour = vec4(srgb(hue), core + 0.55 * halo * halo);
}
