// Colours that colour-blind eyes tell apart, for the legend on the CPU and the shaders alike.
// All are as on screen (sRGB), 0 to 1.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/vector.h"

namespace ballpit::view {

/// Eight hues for "which one", after Okabe and Ito (2008), black replaced by grey.
extern const std::array<vec3, 8> categorical_palette;
/// Evenly spaced colours for "how much", blue to yellow, which every kind of colour-blind eye tells apart; lightness
/// rises evenly, and even the first stands out from the dark background. Colours between are interpolated.
extern const std::array<vec3, 9> sequential_palette;

/// For "to which side, and how far": blue below, vermilion above, pale in the middle, of equal lightness on both sides.
extern const std::array<vec3, 9> diverging_palette;
/// What has no value (NaN).
extern const vec3 no_value_colour;

enum class Palette : std::uint8_t { sequential, diverging, categorical };

/// Repeats after eight.
vec3 categorical(std::uint32_t index);
/// `t` from 0 to 1, clamped; NaN gives 0.
vec3 sequential(float t);
vec3 diverging(float t);
/// As the ball shaders colour a value: low to high, or by its whole number in the categorical palette.
vec3 value_colour(Palette palette, float value, float low, float high);

/// A legend as plain data, for a panel that knows nothing of drawing.
struct LegendEntry {
    vec3 colour{0.0f};
    std::string text;
};
struct LegendTick {
    float place = 0.0f;  // along the bar, 0 to 1
    std::string text;
};
struct ContinuousLegend {
    std::vector<vec3> colours;      // evenly spaced along the bar, to be interpolated
    std::vector<LegendTick> ticks;  // at round numbers, the last one with the unit
};

/// One entry a name, in the order of the categorical palette.
std::vector<LegendEntry> categorical_legend(std::span<const std::string> names);
/// For the sequential or diverging palette; two to six ticks. A range that is empty or not finite has no ticks.
ContinuousLegend continuous_legend(Palette palette, float low, float high, std::string_view unit);

/// From the screen's values to amounts of light, and back.
vec3 linear_from_srgb(const vec3& colour);
vec3 srgb_from_linear(const vec3& colour);

}  // namespace ballpit::view
