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

void scatter_kept_keys(std::span<const Key> keys, std::span<const CellRange> cell_ranges,
                       std::span<const std::uint32_t> tickets, std::span<Key> scattered_keys,
                       std::span<std::uint32_t> origins) {
    scatter_keys(keys, cell_ranges, tickets, scattered_keys);
    for (std::uint32_t place = 0; place < keys.size(); ++place) {
        if (keys[place].cell_id < cell_ranges.size()) {
            origins[cell_ranges[keys[place].cell_id].first + tickets[place]] = place;
        }
    }
}

}  // namespace ballpit::cpu
