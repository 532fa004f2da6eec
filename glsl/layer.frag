#version 330 core
// Texel by pixel, as it was drawn.
uniform sampler2D surface;

layout(location = 0) out vec4 colour;

void main() { colour = texelFetch(surface, ivec2(gl_FragCoord.xy), 0); }
