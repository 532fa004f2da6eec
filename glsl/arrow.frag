#version 330 core
#include "shared/frame.glsl"

#ifdef FADED
flat in float shown;
#define OPACITY shown
#else
#define OPACITY 1.0
#endif

in vec2 edge;
flat in vec3 paint;

layout(location = 0) out vec4 colour;

void main() {
    float rim = smoothstep(0.55, 0.8, abs(edge.x) / max(edge.y, 1e-6));
    colour = vec4(srgb(paint) * mix(1.0, 0.3, rim), OPACITY);
}
