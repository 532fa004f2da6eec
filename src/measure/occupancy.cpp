#include "measure/occupancy.h"

#include <algorithm>

namespace ballpit::measure {

Occupancy occupancy_of(std::span<const CellRange> cell_ranges, std::size_t longest) {
    Occupancy result;
    std::uint64_t balls = 0;
    for (const CellRange& range : cell_ranges) {
        const std::uint32_t count = range.end - range.first;
        const std::size_t bin = std::min<std::size_t>(count, longest - 1);
        if (bin >= result.histogram.size()) {
            result.histogram.resize(bin + 1, 0);
        }
        ++result.histogram[bin];
        balls += count;
        result.occupied += count > 0 ? 1 : 0;
        result.max = std::max(result.max, count);
    }
    result.mean_occupied = result.occupied == 0 ? 0.0 : static_cast<double>(balls) / result.occupied;
    return result;
}

}  // namespace ballpit::measure
