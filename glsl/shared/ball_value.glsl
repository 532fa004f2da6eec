// Colour of a ball by a value of its own, for the programs that colour so. Needs shared/frame.glsl.
#ifdef VALUED
#ifndef BY_NUMBER                        // who looks it up by the ball's number has no attribute
layout(location = 6) in float value;
#endif

// By bits, because a compiler may assume that nothing is NaN.
bool is_nan(float v) { return (floatBitsToUint(v) & 0x7FFFFFFFu) > 0x7F800000u; }

// view::value_colour, in linear light.
vec3 value_colour(float value) {
    if (is_nan(value)) {
        return frame.no_value_colour;
    }
    if (frame.value_palette == PALETTE_CATEGORICAL) {
        bool whole = value >= 0.0 && value < 4294967040.0;
        return whole ? frame.categorical[uint(value) % uint(CATEGORICAL_COLOURS)].rgb : frame.no_value_colour;
    }
    float t = (value - frame.value_low) / max(frame.value_high - frame.value_low, 1e-30);
    return frame.value_palette == PALETTE_DIVERGING ? diverging_colour(t) : sequential_colour(t);
}
#endif
