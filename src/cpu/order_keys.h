// Mirror of glsl/order_keys.comp: the keys of each cell in the order of their ball ids.
#pragma once

#include <span>

#include "core/layout.h"

namespace ballpit::cpu {

/// Leaves in `keys` what is in `scattered_keys` (both one a slot), with the slots of each cell sorted.
void order_keys(std::span<const Key> scattered_keys, std::span<const CellRange> cell_ranges, std::span<Key> keys);

}  // namespace ballpit::cpu
