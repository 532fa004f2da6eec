// When many balls are drawn from afar: a point each, where a model or a ray would be spent on a few pixels.
#pragma once

#include <cstdint>

#include "view/frame.h"
#include "view/picture.h"

namespace ballpit::view {

/// Pixels across below which a ball is drawn as a point, and from how many balls on: fewer are drawn as they are.
inline constexpr auto far_below = static_cast<float>(FAR_BELOW);
inline constexpr std::uint32_t far_from = 30000;

/// Pixels across of the largest balls (which a cell is made to hold), as near as the box lets them be.
float largest_across(const Picture& picture);

/// Whether all balls of the picture are drawn so: then they cast no shadows, either.
bool all_far(const Picture& picture);

}  // namespace ballpit::view
