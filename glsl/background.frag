#version 330 core
#include "shared/background.glsl"

in float height;

layout(location = 0) out vec4 colour;

void main() { colour = vec4(background(height), 1.0); }
