// Element-wise comparison of a buffer of the GPU with the mirror's.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/schedule.h"
#include "core/vector.h"

namespace ballpit::measure {

struct Comparison {
    std::size_t elements = 0;
    std::size_t differing = 0;          // elements with any bit different
    std::size_t beyond_bound = 0;       // of those, the ones that no rounding explains (integers: all)
    std::uint64_t max_ulp = 0;          // largest distance of two floats, in units in the last place
    double max_error = 0.0;             // largest absolute distance of two floats
    double of_bound = 0.0;              // largest distance as a share of its bound, of the elements within theirs
    std::vector<std::uint32_t> places;  // elements that differ, ascending, the first thousand
    std::string first;                  // the first element beyond the bound, else the first that differs, in words
};

/// Units in the last place between two floats: how many floats lie between them, plus one. NaN is as far as
/// can be from every other float, and 0 from a NaN of the same bits.
std::uint64_t ulp_distance(float a, float b);

/// Elements of four bytes or structs of them, as the slot has; `bounds` gives the largest explained distance of
/// each element's floats (empty: none). Sizes that differ count every missing element as beyond.
Comparison compare_slot(Slot slot, std::span<const std::byte> gpu, std::span<const std::byte> cpu,
                        std::span<const double> bounds = {});

}  // namespace ballpit::measure
