#include "cpu/count_tiles.h"

#include <algorithm>

namespace ballpit::cpu {

void count_tiles(std::span<const CellRange> cell_ranges, std::span<std::uint32_t> tile_counts) {
    std::ranges::fill(tile_counts, 0u);
    for (std::size_t cell = 0; cell < cell_ranges.size(); ++cell) {
        tile_counts[cell / TILE_CELLS] += cell_ranges[cell].end;
    }
}

}  // namespace ballpit::cpu
