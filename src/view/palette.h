// Colours that colour-blind eyes tell apart, for the legend on the CPU and the shaders alike.
// All are as on screen (sRGB), 0 to 1.
#pragma once

#include <array>
#include <cstdint>

#include "core/vector.h"

namespace ballpit::view {

/// Eight hues for "which one", after Okabe and Ito (2008), black replaced by grey.
extern const std::array<vec3, 8> categorical_palette;
/// Evenly spaced colours for "how much", blue to yellow, which every kind of colour-blind eye tells apart; lightness
/// rises evenly, and even the first stands out from the dark background. Colours between are interpolated.
extern const std::array<vec3, 9> sequential_palette;

/// Repeats after eight.
vec3 categorical(std::uint32_t index);
/// `t` from 0 to 1, clamped; NaN gives 0.
vec3 sequential(float t);

/// From the screen's values to amounts of light, and back.
vec3 linear_from_srgb(const vec3& colour);
vec3 srgb_from_linear(const vec3& colour);

}  // namespace ballpit::view
