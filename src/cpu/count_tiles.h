// Mirror of glsl/count_tiles.comp: how many balls each tile of the cell table has.
#pragma once

#include <cstdint>
#include <span>

#include "core/layout.h"

namespace ballpit::cpu {

/// tile_counts: one a tile of TILE_CELLS cells, the sum of the counts that count_cells has left in their `end`.
void count_tiles(std::span<const CellRange> cell_ranges, std::span<std::uint32_t> tile_counts);

}  // namespace ballpit::cpu
