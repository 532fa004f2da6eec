// Mirror of glsl/scatter_keys.comp: each key into the slots of its cell.
#pragma once

#include <cstdint>
#include <span>

#include "core/layout.h"

namespace ballpit::cpu {

/// Puts the key of each ball at the place that its ticket names in its cell's slots. keys, tickets: one a ball;
/// scattered_keys: one a slot.
void scatter_keys(std::span<const Key> keys, std::span<const CellRange> cell_ranges,
                  std::span<const std::uint32_t> tickets, std::span<Key> scattered_keys);

/// The same where the order is kept: keys and tickets one a place, and each place is noted as its slot's origin.
void scatter_kept_keys(std::span<const Key> keys, std::span<const CellRange> cell_ranges,
                       std::span<const std::uint32_t> tickets, std::span<Key> scattered_keys,
                       std::span<std::uint32_t> origins);

}  // namespace ballpit::cpu
