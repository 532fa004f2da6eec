#version 330 core
// A ring round the ball's outline in a halo; what shows through veils the ball, too.
in vec2 across;
flat in float ring;
flat in vec4 paint;

uniform bool through;                    // draws what shows through balls

layout(location = 0) out vec4 colour;

void main() {
    float r = length(across);
    float pixel = fwidth(r);
    float outside = smoothstep(1.0 - pixel, 1.0, r);
    float band = outside * (1.0 - smoothstep(1.0 + ring - pixel, 1.0 + ring, r));
    float fall = clamp((r - 1.0 - ring) / (1.5 * ring), 0.0, 1.0);
    float glow = outside * (1.0 - band) * 0.35 * (1.0 - fall) * (1.0 - fall);
    float seen = through ? max(0.55 * band, 0.2 * (1.0 - outside)) : band + glow;
    colour = vec4(paint.rgb, paint.a * seen);
}
