// Mirror of glsl/clear_cells.comp: every cell is empty until it is said otherwise.
#pragma once

#include <cstdint>
#include <span>

#include "core/layout.h"

namespace ballpit::cpu {

/// Empties the cells of the tiles that are marked as written to, and takes the marks away. used_tiles: one a tile.
void clear_cells(std::span<CellRange> cell_ranges, std::span<std::uint32_t> used_tiles);

}  // namespace ballpit::cpu
