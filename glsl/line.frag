#version 330 core
// Round ends, a soft edge, and a dark rim that sets it off from whatever is behind; what shows through has no rim.
noperspective in vec2 place;
flat in float size;
flat in float half_width;
flat in vec4 paint;

uniform bool through;                    // draws what shows through balls

layout(location = 0) out vec4 colour;

void main() {
    float beyond = max(max(-place.x, place.x - size), 0.0);
    float away = length(vec2(beyond, place.y));
    float core = 1.0 - smoothstep(half_width - 0.5, half_width + 0.5, away);
    float rim = through ? 0.0 : 0.55 * (1.0 - smoothstep(half_width + 0.5, half_width + 1.5, away));
    float cover = core + (1.0 - core) * rim;
    colour = vec4(paint.rgb * core / max(cover, 1e-6), cover * paint.a);
}
