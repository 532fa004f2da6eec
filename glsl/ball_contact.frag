#version 330 core
// Multiplied with the ground: overlapping shadows darken more, and never below black.
in vec2 across;
flat in float strength;

layout(location = 0) out vec4 colour;

void main() {
    float inside = max(1.0 - dot(across, across), 0.0);
    colour = vec4(vec3(1.0 - strength * inside * inside), 1.0);
}
