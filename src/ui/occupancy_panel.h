// The bars of the occupancy histogram.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ballpit::ui {

/// Cells that hold `first` to `last` balls.
struct HistogramBar {
    std::uint32_t first;
    std::uint32_t last;
    std::uint64_t cells;
};

/// Bars over histogram[1..max], one a count up to `most_singles` counts, else 1, 2, 3-4, 5-8, 9-16, ... so that one
/// full cell among thousands of sparse ones shows. Empty cells are left out.
std::vector<HistogramBar> histogram_bars(std::span<const std::uint32_t> histogram, std::size_t most_singles);

}  // namespace ballpit::ui
