// Mirror of glsl/scan_cells.comp: from counts to the range of slots of each cell.
#pragma once

#include <span>

#include "core/layout.h"

namespace ballpit::cpu {

/// Each cell's slots begin where those of the cells before it end; an empty cell stays (0, 0). What a sum over tiles
/// gives the shader, a running sum gives here.
void scan_cells(std::span<CellRange> cell_ranges);

}  // namespace ballpit::cpu
