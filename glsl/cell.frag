#version 330 core
// Edges solid, faces a veil: what is behind stays visible.
#include "shared/frame.glsl"

in vec3 local;
flat in vec3 shade;

layout(location = 0) out vec4 colour;

void main() {
    // On a face one coordinate is +-1; the larger of the other two tells how near an edge is.
    vec3 a = abs(local);
    float largest = max(a.x, max(a.y, a.z));
    float smallest = min(a.x, min(a.y, a.z));
    float middle = a.x + a.y + a.z - largest - smallest;
    float pixel = fwidth(middle);
    float edge = smoothstep(1.0 - 2.5 * pixel, 1.0 - 1.0 * pixel, middle);
    colour = vec4(srgb(shade), mix(0.14, 0.9, edge));
}
