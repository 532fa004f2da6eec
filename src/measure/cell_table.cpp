#include "measure/cell_table.h"

#include <algorithm>
#include <numeric>

#include "measure/neighbours.h"

namespace ballpit::measure {

namespace {

std::uint32_t value_of(const Grid& grid, std::span<const CellRange> ranges, std::uint32_t cell, CellColumn column) {
    switch (column) {
        case CellColumn::cell:
            return cell;
        case CellColumn::x:
            return cell_of_id(grid, cell).x;
        case CellColumn::y:
            return cell_of_id(grid, cell).y;
        case CellColumn::z:
            return cell_of_id(grid, cell).z;
        case CellColumn::first:
            return ranges[cell].first;
        case CellColumn::end:
            return ranges[cell].end;
        case CellColumn::balls:
            return ranges[cell].end - ranges[cell].first;
    }
    return 0;
}

// Millions of cells, but few values: counting needs two passes and no comparison.
std::vector<std::uint32_t> counting_sorted(std::span<const std::uint32_t> cells,
                                           std::span<const std::uint32_t> values) {
    std::vector<std::size_t> starts(std::size_t{*std::ranges::max_element(values)} + 2, 0);
    for (const std::uint32_t value : values) {
        ++starts[value + 1];
    }
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    std::vector<std::uint32_t> sorted(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
        sorted[starts[values[i]]++] = cells[i];
    }
    return sorted;
}

// A broken build_grid may leave numbers that no table of counts has room for.
std::vector<std::uint32_t> comparison_sorted(std::span<const std::uint32_t> cells,
                                             std::span<const std::uint32_t> values) {
    std::vector<std::uint64_t> pairs(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
        pairs[i] = std::uint64_t{values[i]} << 32 | cells[i];
    }
    std::ranges::sort(pairs);
    std::vector<std::uint32_t> sorted(cells.size());
    std::ranges::transform(pairs, sorted.begin(), [](std::uint64_t pair) { return static_cast<std::uint32_t>(pair); });
    return sorted;
}

}  // namespace

std::vector<std::uint32_t> ordered_cells(const Grid& grid, std::span<const CellRange> cell_ranges,
                                         const CellOrder& order) {
    std::vector<std::uint32_t> cells;
    for (std::uint32_t cell = 0; cell < cell_ranges.size(); ++cell) {
        if (!order.only_occupied || cell_ranges[cell].first != cell_ranges[cell].end) {
            cells.push_back(cell);
        }
    }
    if (cells.empty()) {
        return cells;
    }
    if (order.column != CellColumn::cell) {
        std::vector<std::uint32_t> values(cells.size());
        std::ranges::transform(cells, values.begin(),
                               [&](std::uint32_t cell) { return value_of(grid, cell_ranges, cell, order.column); });
        if (order.descending) {
            // The values are turned round, not the list: equal ones keep their order.
            const std::uint32_t most = *std::ranges::max_element(values);
            std::ranges::transform(values, values.begin(), [most](std::uint32_t value) { return most - value; });
        }
        constexpr std::uint32_t most_counted = 1u << 25;
        const bool countable = *std::ranges::max_element(values) < most_counted;
        return countable ? counting_sorted(cells, values) : comparison_sorted(cells, values);
    }
    if (order.descending) {
        std::ranges::reverse(cells);
    }
    return cells;
}

std::optional<std::size_t> row_of_cell(std::span<const std::uint32_t> cells, std::uint32_t cell_id) {
    const auto found = std::ranges::find(cells, cell_id);
    return found == cells.end() ? std::nullopt
                                : std::optional<std::size_t>(static_cast<std::size_t>(found - cells.begin()));
}

}  // namespace ballpit::measure
