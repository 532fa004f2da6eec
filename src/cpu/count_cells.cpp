#include "cpu/count_cells.h"

namespace ballpit::cpu {

void count_cells(std::span<const Key> keys, std::span<CellRange> cell_ranges, std::span<std::uint32_t> used_tiles,
                 std::span<std::uint32_t> tickets, Status& status) {
    for (std::size_t ball = 0; ball < keys.size(); ++ball) {
        const std::uint32_t cell = keys[ball].cell_id;
        if (cell >= cell_ranges.size()) {
            status.bits |= STATUS_OVER_CAPACITY;
            ++status.over_capacity;
            continue;
        }
        tickets[ball] = cell_ranges[cell].end++;
        used_tiles[cell / TILE_CELLS] = 1;
    }
}

}  // namespace ballpit::cpu
