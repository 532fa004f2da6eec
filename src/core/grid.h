// The uniform grid over the box: cell width, cells along each axis, cell ids.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/box.h"
#include "core/vector.h"

namespace ballpit {

struct Grid {
    dvec3 origin{0.0};        // m, lower corner of cell 0
    double cell_width = 1.0;  // m
    uvec3 cells{1};           // along x, y, z; cell id = (z * cells.y + y) * cells.x + x

    std::uint32_t cell_count() const { return cells.x * cells.y * cells.z; }
};

/// Cells that the table may have for this many balls: enough for balls that fill a sixteenth of their box, few enough
/// for the memory of a device.
std::uint32_t maximum_cells(std::uint32_t ball_count);

/// Cell width 2 * r_max * cell_factor and a little more, so that rounding never misses a pair; wider where the box
/// would need more than maximum_cells. Balls outside the box belong to the outermost cells.
Grid make_grid(const Box& box, double r_max, double cell_factor, std::uint32_t ball_count);

/// The cell that a point lies in; outside the box, or where it is no number, the nearest that there is. In double, for
/// who asks about a grid on the host: next to a cell's wall the stages may answer otherwise, because they round to
/// float. Those have their own (glsl/shared/cells.glsl and its mirror), which multiply as the shader does and have to
/// agree with each other to the last bit.
uvec3 cell_of(const dvec3& point, const Grid& grid);

std::size_t cell_id(const uvec3& cell, const Grid& grid);

}  // namespace ballpit
