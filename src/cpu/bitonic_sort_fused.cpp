#include "cpu/bitonic_sort_fused.h"

#include <algorithm>

namespace ballpit::cpu {

void bitonic_sort_fused(std::span<Key> keys, std::uint32_t k_last, std::uint32_t tile_size) {
    for (std::size_t start = 0; start < keys.size(); start += tile_size) {
        const auto tile = keys.subspan(start, std::min<std::size_t>(tile_size, keys.size() - start));
        const bool ascending = (start & k_last) == 0;
        std::sort(tile.begin(), tile.end(),
                  [ascending](const Key& a, const Key& b) { return ascending ? a < b : b < a; });
    }
}

}  // namespace ballpit::cpu
