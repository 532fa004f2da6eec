#version 330 core
// Edges are lines, faces a veil, both fainter where few balls are: the full cells of a pile stand out of the many.
#include "shared/frame.glsl"

in vec3 local;
flat in vec4 shade;

layout(location = 0) out vec4 colour;

void main() {
    // On a face one coordinate is +-1; the larger of the other two tells how near an edge is.
    vec3 a = abs(local);
    float largest = max(a.x, max(a.y, a.z));
    float smallest = min(a.x, min(a.y, a.z));
    float middle = a.x + a.y + a.z - largest - smallest;
    float pixel = fwidth(middle);
    float edge = smoothstep(1.0 - 2.5 * pixel, 1.0 - 1.0 * pixel, middle);
    float veil = mix(0.05, 0.35, shade.w);
    float line = mix(0.4, 1.0, shade.w);
    colour = vec4(srgb(shade.rgb), mix(veil, line, edge));
}
