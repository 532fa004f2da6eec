#include "cpu/order_keys.h"

#include <algorithm>
#include <vector>

namespace ballpit::cpu {

void order_keys(std::span<const Key> scattered_keys, std::span<const CellRange> cell_ranges, std::span<Key> keys) {
    for (const CellRange& range : cell_ranges) {
        const auto slots = keys.subspan(range.first, range.end - range.first);
        std::ranges::copy(scattered_keys.subspan(range.first, slots.size()), slots.begin());
        std::sort(slots.begin(), slots.end(), [](const Key& a, const Key& b) { return a < b; });
    }
}

template <class Real>
void order_keys_and_state(std::span<const Key> scattered_keys, std::span<const std::uint32_t> origins,
                          std::span<const CellRange> cell_ranges, std::span<const Vec4<Real>> positions,
                          std::span<const Vec4<Real>> velocities, std::span<Key> keys,
                          std::span<Vec4<Real>> sorted_positions, std::span<Vec4<Real>> sorted_velocities) {
    order_keys(scattered_keys, cell_ranges, keys);
    std::vector<std::uint32_t> place_of(keys.size());  // by ball
    for (std::size_t slot = 0; slot < scattered_keys.size(); ++slot) {
        place_of[scattered_keys[slot].ball_id] = origins[slot];
    }
    for (std::size_t slot = 0; slot < keys.size(); ++slot) {
        sorted_positions[slot] = positions[place_of[keys[slot].ball_id]];
        sorted_velocities[slot] = velocities[place_of[keys[slot].ball_id]];
    }
}

template void order_keys_and_state(std::span<const Key>, std::span<const std::uint32_t>, std::span<const CellRange>,
                                   std::span<const Vec4<float>>, std::span<const Vec4<float>>, std::span<Key>,
                                   std::span<Vec4<float>>, std::span<Vec4<float>>);
template void order_keys_and_state(std::span<const Key>, std::span<const std::uint32_t>, std::span<const CellRange>,
                                   std::span<const Vec4<double>>, std::span<const Vec4<double>>, std::span<Key>,
                                   std::span<Vec4<double>>, std::span<Vec4<double>>);

}  // namespace ballpit::cpu
