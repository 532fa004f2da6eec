// Mirror of glsl/order_keys.comp: the keys of each cell in the order of their ball ids.
#pragma once

#include <cstdint>
#include <span>

#include "core/layout.h"
#include "core/vector.h"

namespace ballpit::cpu {

/// Leaves in `keys` what is in `scattered_keys` (both one a slot), with the slots of each cell sorted.
void order_keys(std::span<const Key> scattered_keys, std::span<const CellRange> cell_ranges, std::span<Key> keys);

/// The same where the order is kept: the state, too, from the places where it is (`origins`, one a scattered key) to
/// the slots of the keys.
template <class Real>
void order_keys_and_state(std::span<const Key> scattered_keys, std::span<const std::uint32_t> origins,
                          std::span<const CellRange> cell_ranges, std::span<const Vec4<Real>> positions,
                          std::span<const Vec4<Real>> velocities, std::span<Key> keys,
                          std::span<Vec4<Real>> sorted_positions, std::span<Vec4<Real>> sorted_velocities);

}  // namespace ballpit::cpu
