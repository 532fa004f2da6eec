#include "measure/sort_pass.h"

#include <algorithm>
#include <bit>

namespace ballpit::measure {

std::uint32_t pass_number(std::uint32_t k, std::uint32_t j) {
    // The stages before k = 2^s have 1 + 2 + ... + (s - 1) passes; within it j runs from k / 2 down to 1.
    const auto stage = static_cast<std::uint32_t>(std::countr_zero(k));
    const auto within = static_cast<std::uint32_t>(std::countr_zero(k) - std::countr_zero(j));
    return stage * (stage - 1) / 2 + within;
}

std::uint32_t pass_count(std::uint32_t key_count) {
    if (key_count < 2) {
        return 0;
    }
    const auto stages = static_cast<std::uint32_t>(std::countr_zero(key_count));
    return stages * (stages + 1) / 2;
}

CompareExchange compare_exchange_of(std::uint32_t slot, std::uint32_t k, std::uint32_t j, std::span<const Key> before) {
    CompareExchange pair;
    pair.lower = std::min(slot, slot ^ j);
    pair.upper = pair.lower ^ j;
    pair.thread = (pair.lower / (2 * j)) * j + pair.lower % j;
    pair.ascending = (pair.lower & k) == 0;
    const Key& low = before[pair.lower];
    const Key& high = before[pair.upper];
    pair.swapped = pair.ascending ? high < low : low < high;
    return pair;
}

std::uint32_t count_swaps(std::uint32_t k, std::uint32_t j, std::span<const Key> before) {
    std::uint32_t swaps = 0;
    for (std::uint32_t slot = 0; slot < before.size(); ++slot) {
        if ((slot & j) == 0) {
            swaps += compare_exchange_of(slot, k, j, before).swapped ? 1 : 0;
        }
    }
    return swaps;
}

}  // namespace ballpit::measure
