#version 330 core
// Only depth is kept.
in vec2 across;

void main() {
    if (dot(across, across) > 1.0) {
        discard;
    }
}
