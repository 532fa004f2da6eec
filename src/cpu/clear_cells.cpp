#include "cpu/clear_cells.h"

#include <algorithm>

namespace ballpit::cpu {

void clear_cells(std::span<CellRange> cell_ranges, std::span<std::uint32_t> used_tiles) {
    for (std::size_t tile = 0; tile < used_tiles.size(); ++tile) {
        if (used_tiles[tile] != 0) {
            used_tiles[tile] = 0;
            const std::size_t first = tile * TILE_CELLS;
            const std::size_t count = std::min<std::size_t>(TILE_CELLS, cell_ranges.size() - first);
            std::ranges::fill(cell_ranges.subspan(first, count), CellRange{0, 0});
        }
    }
}

}  // namespace ballpit::cpu
