// Mirror of glsl/keep_places.comp: where balls are now that a grid has been built.
#pragma once

#include <span>

#include "core/vector.h"

namespace ballpit::cpu {

/// positions and built_positions: ball_count each.
template <class Real>
void keep_places(std::span<const Vec4<Real>> positions, std::span<Vec4<Real>> built_positions);

}  // namespace ballpit::cpu
