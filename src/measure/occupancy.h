// How full the cells are.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/layout.h"

namespace ballpit::measure {

struct Occupancy {
    std::vector<std::uint32_t> histogram;  // [balls in a cell] -> cells; empty cells at index 0
    std::uint32_t occupied = 0;            // cells with at least one ball
    std::uint32_t max = 0;                 // balls in the fullest cell
    double mean_occupied = 0.0;            // balls in an occupied cell, on average
};

/// Counts above `longest - 1` share the histogram's last bin.
Occupancy occupancy_of(std::span<const CellRange> cell_ranges, std::size_t longest = 64);

}  // namespace ballpit::measure
