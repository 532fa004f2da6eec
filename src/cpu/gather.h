// Mirror of glsl/gather.comp: copies of the state in the order of the sorted keys.
#pragma once

#include <span>

#include "core/layout.h"
#include "core/vector.h"

namespace ballpit::cpu {

/// keys: sorted, those of the balls; the state: one a ball; the copies: one a slot.
template <class Real>
void gather(std::span<const Key> keys, std::span<const Vec4<Real>> positions, std::span<const Vec4<Real>> velocities,
            std::span<Vec4<Real>> sorted_positions, std::span<Vec4<Real>> sorted_velocities);

}  // namespace ballpit::cpu
