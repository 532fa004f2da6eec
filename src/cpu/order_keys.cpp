#include "cpu/order_keys.h"

#include <algorithm>

namespace ballpit::cpu {

void order_keys(std::span<const Key> scattered_keys, std::span<const CellRange> cell_ranges, std::span<Key> keys) {
    for (const CellRange& range : cell_ranges) {
        const auto slots = keys.subspan(range.first, range.end - range.first);
        std::ranges::copy(scattered_keys.subspan(range.first, slots.size()), slots.begin());
        std::sort(slots.begin(), slots.end(), [](const Key& a, const Key& b) { return a < b; });
    }
}

}  // namespace ballpit::cpu
