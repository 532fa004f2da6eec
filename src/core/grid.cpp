#include "core/grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ballpit {

std::uint32_t maximum_cells(std::uint32_t ball_count) {
    const std::uint64_t wanted = 16ull * ball_count;
    return static_cast<std::uint32_t>(std::clamp<std::uint64_t>(wanted, 1u << 15, 1u << 26));
}

Grid make_grid(const Box& box, double r_max, double cell_factor, std::uint32_t ball_count) {
    const auto limit = static_cast<double>(maximum_cells(ball_count));
    Grid grid;
    grid.origin = box.lower;
    grid.cell_width = std::max(2.0 * r_max * cell_factor, 1e-6);
    const dvec3 size = box.size();
    const auto cells_along = [&](int axis) { return std::max(1.0, std::ceil(size[axis] / grid.cell_width)); };
    while (cells_along(0) * cells_along(1) * cells_along(2) > limit) {
        grid.cell_width *= 1.02;
    }
    // A float coordinate, counted in cells, is off by up to 1.5 ulp of the far wall. Two balls that barely touch must
    // not be rounded into cells that are not neighbours, so a cell is wider than the diameter by twice that each.
    const double farthest = std::max({cells_along(0), cells_along(1), cells_along(2)});
    grid.cell_width *= 1.0 + 6.0 * farthest * static_cast<double>(std::numeric_limits<float>::epsilon());
    for (int axis = 0; axis < 3; ++axis) {
        grid.cells[axis] = static_cast<std::uint32_t>(cells_along(axis));
    }
    return grid;
}

uvec3 cell_of(const dvec3& point, const Grid& grid) {
    uvec3 cell(0);
    for (int axis = 0; axis < 3; ++axis) {
        const double place = (point[axis] - grid.origin[axis]) / grid.cell_width;
        const double last = grid.cells[axis] - 1.0;
        cell[axis] = static_cast<std::uint32_t>(place > 0.0 ? std::min(place, last) : 0.0);  // of no number: 0
    }
    return cell;
}

std::size_t cell_id(const uvec3& cell, const Grid& grid) {
    return (std::size_t{cell.z} * grid.cells.y + cell.y) * grid.cells.x + cell.x;
}

}  // namespace ballpit
