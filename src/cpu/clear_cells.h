// Mirror of glsl/clear_cells.comp: every cell is empty until build_grid says otherwise.
#pragma once

#include <span>

#include "core/layout.h"

namespace ballpit::cpu {

void clear_cells(std::span<CellRange> cell_ranges);

}  // namespace ballpit::cpu
