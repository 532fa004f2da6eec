// Mirror of glsl/count_cells.comp: how many balls each cell has.
#pragma once

#include <cstdint>
#include <span>

#include "core/layout.h"

namespace ballpit::cpu {

/// Counts each ball into `end` of its cell's range, marks the cell's tile, and gives the ball a ticket: how many of the
/// cell's balls were counted before it; here in the order of ball ids, on a GPU in any order.
/// keys: those of the balls, in the order of ball ids; cell_ranges: empty; tickets: one a ball. Keys of cells that do
/// not exist are counted in `status` alone.
void count_cells(std::span<const Key> keys, std::span<CellRange> cell_ranges, std::span<std::uint32_t> used_tiles,
                 std::span<std::uint32_t> tickets, Status& status);

}  // namespace ballpit::cpu
