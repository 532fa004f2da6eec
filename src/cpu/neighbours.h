// The other balls that a ball meets: those in the 27 cells around it, in the order of cells and slots, or all of them
// in the order of their ids. One order, so that sums do not depend on who runs when.
#pragma once

#include "core/features.h"
#include "cpu/assign_cells.h"

namespace ballpit::cpu {

/// Calls meet(id) for each ball in the cells around `position` (m), ball `self` left out. keys: sorted; cell_ranges:
/// one a cell of the grid in `params`.
template <class Real, class Meet>
void for_each_in_cells_around(const SubstepParams<Real>& params, std::span<const Key> keys,
                              std::span<const CellRange> cell_ranges, const Vec3<Real>& position, std::uint32_t self,
                              const Meet& meet) {
    const uvec3 middle = cell_coordinates(params, position);
    const uvec3 low = middle - glm::min(middle, uvec3(1));
    const uvec3 high = glm::min(middle + 1u, params.grid_cells - 1u);
    for (std::uint32_t z = low.z; z <= high.z; ++z) {
        for (std::uint32_t y = low.y; y <= high.y; ++y) {
            for (std::uint32_t x = low.x; x <= high.x; ++x) {
                const CellRange range = cell_ranges[(z * params.grid_cells.y + y) * params.grid_cells.x + x];
                for (std::uint32_t slot = range.first; slot < range.end; ++slot) {
                    if (const std::uint32_t id = keys[slot].ball_id; id != self) {
                        meet(id);
                    }
                }
            }
        }
    }
}

/// The same, or all balls but `self`, as `features` have it.
template <class Real, class Meet>
void for_each_neighbour(const SubstepParams<Real>& params, Features features, std::span<const Key> keys,
                        std::span<const CellRange> cell_ranges, const Vec3<Real>& position, std::uint32_t self,
                        const Meet& meet) {
    if (!features.has(Feature::brute_force)) {
        for_each_in_cells_around(params, keys, cell_ranges, position, self, meet);
        return;
    }
    for (std::uint32_t id = 0; id < params.ball_count; ++id) {
        if (id != self) {
            meet(id);
        }
    }
}

}  // namespace ballpit::cpu
