#include "cpu/scatter_keys.h"

namespace ballpit::cpu {

void scatter_keys(std::span<const Key> keys, std::span<const CellRange> cell_ranges,
                  std::span<const std::uint32_t> tickets, std::span<Key> scattered_keys) {
    for (std::size_t ball = 0; ball < keys.size(); ++ball) {
        if (keys[ball].cell_id < cell_ranges.size()) {
            scattered_keys[cell_ranges[keys[ball].cell_id].first + tickets[ball]] = keys[ball];
        }
    }
}

}  // namespace ballpit::cpu
