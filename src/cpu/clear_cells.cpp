#include "cpu/clear_cells.h"

#include <algorithm>

namespace ballpit::cpu {

void clear_cells(std::span<CellRange> cell_ranges) { std::ranges::fill(cell_ranges, CellRange{0, 0}); }

}  // namespace ballpit::cpu
