// Mirror of glsl/build_grid.comp: from sorted keys to the range of slots of each cell.
#pragma once

#include <cstdint>
#include <span>

#include "core/layout.h"

namespace ballpit::cpu {

/// A slot whose neighbour below belongs to another cell writes `first` and marks the cell's tile, one whose neighbour
/// above does writes `end`. keys: the sorted keys of the balls, without padding; used_tiles: one a tile of the table.
/// Keys of cells that do not exist are counted, not written.
void build_grid(std::span<const Key> keys, std::span<CellRange> cell_ranges, std::span<std::uint32_t> used_tiles,
                Status& status);

}  // namespace ballpit::cpu
