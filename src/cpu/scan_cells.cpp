#include "cpu/scan_cells.h"

namespace ballpit::cpu {

void scan_cells(std::span<CellRange> cell_ranges) {
    std::uint32_t next = 0;
    for (CellRange& range : cell_ranges) {
        if (const std::uint32_t count = range.end; count > 0) {
            range = {next, next + count};
            next += count;
        }
    }
}

}  // namespace ballpit::cpu
