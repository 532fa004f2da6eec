#include "cpu/build_grid.h"

namespace ballpit::cpu {

void build_grid(std::span<const Key> keys, std::span<CellRange> cell_ranges, std::span<std::uint32_t> used_tiles,
                Status& status) {
    for (std::uint32_t slot = 0; slot < keys.size(); ++slot) {
        const std::uint32_t cell = keys[slot].cell_id;
        if (cell >= cell_ranges.size()) {
            status.bits |= STATUS_OVER_CAPACITY;
            ++status.over_capacity;
            continue;
        }
        if (slot == 0 || keys[slot - 1].cell_id != cell) {
            cell_ranges[cell].first = slot;
            used_tiles[cell / TILE_CELLS] = 1;
        }
        if (slot + 1 == keys.size() || keys[slot + 1].cell_id != cell) {
            cell_ranges[cell].end = slot + 1;
        }
    }
}

}  // namespace ballpit::cpu
