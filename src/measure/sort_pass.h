// What one pass of the bitonic network did to the keys, and what the microscope says about a slot.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/layout.h"
#include "core/schedule.h"

namespace ballpit::measure {

/// A compare-exchange of a pass: slots lower < upper = lower XOR j.
struct CompareExchange {
    std::uint32_t lower = 0;
    std::uint32_t upper = 0;
    std::uint32_t thread = 0;  // index of the thread that does it
    bool ascending = true;     // because bit k of `lower` is 0
    bool swapped = false;
};

/// Number of a pass among all passes of a sort of `key_count` keys, from 1; (k, j) as in the schedule.
std::uint32_t pass_number(std::uint32_t k, std::uint32_t j);
std::uint32_t pass_count(std::uint32_t key_count);

/// The compare-exchange that a slot takes part in, from the keys before the pass.
CompareExchange compare_exchange_of(std::uint32_t slot, std::uint32_t k, std::uint32_t j, std::span<const Key> before);

/// Pairs of slots that the pass exchanges, from the keys before it.
std::uint32_t count_swaps(std::uint32_t k, std::uint32_t j, std::span<const Key> before);

}  // namespace ballpit::measure
