// When balls are many, and when they are far: where a model or a ray would be spent on a few pixels.
#pragma once

#include <cstdint>

#include "view/frame.h"
#include "view/picture.h"

namespace ballpit::view {

/// Pixels across below which a ball is far, and how many are many: of fewer each is drawn by itself.
inline constexpr auto far_below = static_cast<float>(FAR_BELOW);
inline constexpr std::uint32_t far_from = 30000;

/// Pixels across of the largest balls (which a cell is made to hold), as near as the box lets them be.
float largest_across(const Picture& picture);

/// Whether the balls of the picture are many and all of them far: then they cast no shadows.
bool all_far(const Picture& picture);

}  // namespace ballpit::view
