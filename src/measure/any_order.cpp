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

template <class T>
Bytes each_cell_sorted(std::vector<T> elements, std::span<const CellRange> cell_ranges) {
    for (const CellRange& range : cell_ranges) {
        if (range.first <= range.end && range.end <= elements.size()) {
            std::sort(elements.begin() + range.first, elements.begin() + range.end,
                      [](const T& a, const T& b) { return a < b; });
        }
    }
    return copied(elements);
}

}  // namespace

bool any_order(Slot slot) { return slot == Slot::tickets || slot == Slot::scattered_keys || slot == Slot::origins; }

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
    return each_cell_sorted(typed<Key>(scattered_keys), cell_ranges);
}

Bytes origins_in_order(std::span<const std::byte> origins, std::span<const CellRange> cell_ranges) {
    return each_cell_sorted(typed<std::uint32_t>(origins), cell_ranges);
}

}  // namespace ballpit::measure
