#include "measure/any_order.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace ballpit::measure {

namespace {

template <class T>
Bytes copied(const std::vector<T>& elements) {
    const auto bytes = std::as_bytes(std::span(elements));
    return {bytes.begin(), bytes.end()};
}

}  // namespace

bool any_order(Slot slot) { return slot == Slot::tickets || slot == Slot::scattered_keys; }

Bytes tickets_in_order(std::span<const std::byte> tickets, std::span<const Key> keys) {
    auto sorted = typed<std::uint32_t>(tickets);
    std::vector<std::uint32_t> balls(std::min(sorted.size(), keys.size()));
    std::iota(balls.begin(), balls.end(), 0u);
    std::ranges::stable_sort(balls, {}, [&](std::uint32_t ball) { return keys[ball].cell_id; });
    for (std::size_t first = 0; first < balls.size();) {
        std::vector<std::uint32_t> of_cell;
        std::size_t end = first;
        for (; end < balls.size() && keys[balls[end]].cell_id == keys[balls[first]].cell_id; ++end) {
            of_cell.push_back(sorted[balls[end]]);
        }
        std::ranges::sort(of_cell);
        for (const std::uint32_t ticket : of_cell) {
            sorted[balls[first++]] = ticket;
        }
    }
    return copied(sorted);
}

Bytes scattered_in_order(std::span<const std::byte> scattered_keys, std::span<const CellRange> cell_ranges) {
    auto sorted = typed<Key>(scattered_keys);
    for (const CellRange& range : cell_ranges) {
        if (range.first <= range.end && range.end <= sorted.size()) {
            std::sort(sorted.begin() + range.first, sorted.begin() + range.end,
                      [](const Key& a, const Key& b) { return a < b; });
        }
    }
    return copied(sorted);
}

}  // namespace ballpit::measure
