// Balls from near to far: what is drawn first hides what is drawn later, and nothing is worked out of that.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/vector.h"
#include "view/camera.h"

namespace ballpit::view {

/// The numbers of the balls, those nearer to the camera's plane first, to a thousandth of the way to the farthest: an
/// order to draw in quickly, not one to rely on. A ball whose place is no number comes anywhere. positions: centre (m),
/// radius (m).
std::vector<std::uint32_t> nearest_first(std::span<const vec4> positions, const Camera& camera);

}  // namespace ballpit::view
