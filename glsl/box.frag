#version 330 core
in float across;

layout(location = 0) out vec4 colour;

void main() { colour = vec4(0.80, 0.86, 0.93, 0.85 * (1.0 - smoothstep(0.35, 1.0, abs(across)))); }
