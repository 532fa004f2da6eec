// Mirror of glsl/start_order.comp: a first order to keep, that of the balls' ids.
#pragma once

#include <span>

#include "core/layout.h"
#include "core/vector.h"

namespace ballpit::cpu {

/// The state, one a ball, becomes the state in that order, and the first keys name the balls.
template <class Real>
void start_order(std::span<const Vec4<Real>> positions, std::span<const Vec4<Real>> velocities,
                 std::span<Vec4<Real>> next_positions, std::span<Vec4<Real>> next_velocities, std::span<Key> keys);

}  // namespace ballpit::cpu
