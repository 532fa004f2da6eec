// The cells in the order in which a table shows them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/grid.h"
#include "core/layout.h"

namespace ballpit::measure {

enum class CellColumn : std::uint8_t { cell, x, y, z, first, end, balls };

struct CellOrder {
    CellColumn column = CellColumn::cell;
    bool descending = false;
    bool only_occupied = true;
    friend bool operator==(const CellOrder&, const CellOrder&) = default;
};

/// Ids of the cells, sorted by a column; equal ones by their ids, ascending. O(cells), whatever the column.
/// `cell_ranges` has one entry a cell of the grid.
std::vector<std::uint32_t> ordered_cells(const Grid& grid, std::span<const CellRange> cell_ranges,
                                         const CellOrder& order);

/// Where a cell stands in that list; nothing if it is filtered out.
std::optional<std::size_t> row_of_cell(std::span<const std::uint32_t> cells, std::uint32_t cell_id);

}  // namespace ballpit::measure
