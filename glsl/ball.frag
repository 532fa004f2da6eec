#version 330 core
#include "shared/frame.glsl"
#include "shared/lighting.glsl"
#include "shared/ball_surface.glsl"

#ifdef FADED
flat in float shown;
#define OPACITY shown
#else
#define OPACITY 1.0
#endif

in vec3 place;
in vec3 normal;
in vec2 uv;
flat in vec4 tint;

layout(location = 0) out vec4 colour;

void main() { colour = vec4(ball_colour(texture(surface, uv).rgb, tint, place, normalize(normal)), OPACITY); }
