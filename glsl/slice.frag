#version 330 core
// Occupied cells are coloured and carry their number where it can be read; empty ones are outlines only.
#include "shared/frame.glsl"

in vec2 local;
flat in vec4 shade;
flat in uint count;

uniform bool through;                    // draws what shows through balls

layout(location = 0) out vec4 colour;

const vec2 digit_size = vec2(0.6, 1.0);  // cell half widths, of a number that stands alone
const float gap = 1.3;                   // digit widths from one digit to the next
const float readable = 0.11;             // cell half widths a pixel

// Digits of 3 x 5 dots: bit 0 is the upper left one, row by row.
const uint digits[10] = uint[](0x7B6Fu, 0x749Au, 0x73E7u, 0x79E7u, 0x49EDu, 0x79CFu, 0x7BCFu, 0x4927u, 0x7BEFu, 0x79EFu);

float number(vec2 at) {
    uint places = count < 10u ? 1u : count < 100u ? 2u : 3u;
    uint rest = min(count, 999u);
    vec2 size = digit_size * (places < 3u ? 1.0 : 0.75);
    float right = 0.5 * gap * size.x * (float(places) - 1.0);
    for (uint i = 0u; i < places; ++i, rest /= 10u, right -= gap * size.x) {
        vec2 dot_at = floor(vec2(3.0, 5.0) * (0.5 + vec2(at.x - right, -at.y) / size));
        if (all(greaterThanEqual(dot_at, vec2(0.0))) && dot_at.x < 3.0 && dot_at.y < 5.0) {
            return float((digits[rest % 10u] >> uint(3.0 * dot_at.y + dot_at.x)) & 1u);
        }
    }
    return 0.0;
}

void main() {
    float strength = through ? 0.25 : 1.0;
    vec2 pixel = fwidth(local);
    vec2 to_side = 1.0 - abs(local);
    vec2 near_side = 1.0 - smoothstep(0.75 * pixel, 1.5 * pixel, to_side);
    float line = max(near_side.x, near_side.y);
    if (count == 0u) {
        colour = vec4(0.75, 0.80, 0.88, strength * 0.28 * line);
        return;
    }
    float text = number(local) * (1.0 - smoothstep(0.75 * readable, readable, max(pixel.x, pixel.y)));
    vec3 ground = srgb(shade.rgb) * mix(1.0, 1.25, line);
    colour = vec4(mix(ground, vec3(0.05, 0.06, 0.09), text), strength * mix(0.72, 0.95, max(line, text)));
}
