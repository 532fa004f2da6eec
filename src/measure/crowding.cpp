#include "measure/crowding.h"

#include <algorithm>
#include <vector>

#include "measure/pairs.h"

namespace ballpit::measure {

namespace {

// The balls by cell; a ball outside the box, or nowhere, belongs to the outermost cell, as in assign_cells.
class Cells {
public:
    Cells(std::span<const vec4> positions, const Grid& grid)
        : grid_(grid), first_(grid.cell_count() + 1, 0), balls_(positions.size()) {
        for (const vec4& position : positions) {
            ++first_[index(position) + 1];
        }
        for (std::size_t i = 1; i < first_.size(); ++i) {
            first_[i] += first_[i - 1];
        }
        std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
        for (std::uint32_t ball = 0; ball < positions.size(); ++ball) {
            balls_[next[index(positions[ball])]++] = ball;
        }
    }

    /// Those of a row of up to three cells, along x around `middle`; none beyond the grid.
    std::span<const std::uint32_t> row(const glm::ivec3& middle, int y, int z) const {
        const glm::ivec3 cells(grid_.cells);
        if (y < 0 || z < 0 || y >= cells.y || z >= cells.z) {
            return {};
        }
        const std::size_t low = index({std::max(middle.x - 1, 0), y, z});
        const std::size_t high = index({std::min(middle.x + 1, cells.x - 1), y, z});
        return std::span(balls_).subspan(first_[low], first_[high + 1] - first_[low]);
    }

private:
    std::size_t index(const glm::ivec3& cell) const { return cell_id(uvec3(cell), grid_); }
    std::size_t index(const vec4& position) const { return cell_id(cell_of(dvec3(position), grid_), grid_); }

    Grid grid_;
    std::vector<std::uint32_t> first_;
    std::vector<std::uint32_t> balls_;
};

}  // namespace

Crowding crowding_of(std::span<const vec4> positions, const Grid& grid, std::uint32_t most) {
    const Cells cells(positions, grid);
    const std::size_t step = std::max<std::size_t>(1, (positions.size() + most - 1) / std::max(most, 1u));
    std::uint64_t candidates = 0;
    std::uint64_t contacts = 0;
    std::uint64_t asked = 0;
    for (std::size_t ball = 0; ball < positions.size(); ball += step, ++asked) {
        const glm::ivec3 middle(cell_of(dvec3(positions[ball]), grid));
        for (int z = middle.z - 1; z <= middle.z + 1; ++z) {
            for (int y = middle.y - 1; y <= middle.y + 1; ++y) {
                for (const std::uint32_t other : cells.row(middle, y, z)) {
                    candidates += other != ball ? 1 : 0;
                    contacts += other != ball && touching(positions[ball], positions[other]) ? 1 : 0;
                }
            }
        }
    }
    Crowding crowding;
    if (asked > 0) {
        crowding.candidates = static_cast<double>(candidates) / static_cast<double>(asked);
        crowding.contacts = static_cast<double>(contacts) / static_cast<double>(asked);
    }
    return crowding;
}

}  // namespace ballpit::measure
