// The scenes that ship, held to what they promise.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>

#include "core/backend.h"

namespace ballpit::test {

/// How many balls a scene is run with, where that is not its own count; those that it lists are always there.
inline constexpr std::uint32_t few_balls = 60;

/// Runs 600 steps of every shipped scene with at most `most_balls` balls, if it does not list more. After each step all
/// balls must be finite, the stages must have nothing to report, and speed, overlap and distance from the box must be
/// within the scene's bounds. With `told`, prints how much of its bounds each scene used.
void gallery_keeps_its_bounds(const std::function<std::unique_ptr<Backend>()>& make_backend, std::uint32_t most_balls,
                              bool told);

}  // namespace ballpit::test
