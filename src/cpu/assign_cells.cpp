#include "cpu/assign_cells.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "cpu/count_cells.h"

namespace ballpit::cpu {

template <class Real>
uvec3 cell_coordinates(const SubstepParams<Real>& params, const Vec3<Real>& point) {
    uvec3 cell;
    for (int axis = 0; axis < 3; ++axis) {
        Real coordinate = (point[axis] - params.grid_origin[axis]) * params.inverse_cell_width;
        if (std::isnan(coordinate)) {
            coordinate = 0;
        }
        // Clamped as a number, before the conversion, which rounds down: a float out of range has no defined integer.
        const Real last = static_cast<Real>(params.grid_cells[axis] - 1);
        cell[axis] = static_cast<std::uint32_t>(std::clamp(coordinate, Real(0), last));
    }
    return cell;
}

template <class Real>
void assign_cells(const SubstepParams<Real>& params, std::span<const Vec4<Real>> positions, std::span<Key> keys,
                  Status& status, BallRange balls) {
    for (std::uint32_t ball = balls.first; ball < balls.end; ++ball) {
        const Vec3<Real> centre(positions[ball]);
        const uvec3 cell = cell_coordinates(params, centre);
        keys[ball] = {(cell.z * params.grid_cells.y + cell.y) * params.grid_cells.x + cell.x, ball};
        if (glm::any(glm::lessThan(centre, params.box_lower)) || glm::any(glm::greaterThan(centre, params.box_upper))) {
            status.bits |= STATUS_OUT_OF_BOUNDS;
            ++status.out_of_bounds;
        }
    }
    if (balls.end == params.ball_count) {
        std::fill(keys.begin() + params.ball_count, keys.end(), Key{SENTINEL, SENTINEL});
    }
}

template <class Real>
void assign_and_count(const SubstepParams<Real>& params, std::span<const Vec4<Real>> kept_positions,
                      std::span<Key> keys, std::span<CellRange> cell_ranges, std::span<std::uint32_t> used_tiles,
                      std::span<std::uint32_t> tickets, Status& status) {
    const std::vector<Key> before(keys.begin(), keys.end());
    assign_cells<Real>(params, kept_positions, keys, status, {0, params.ball_count});
    for (std::uint32_t place = 0; place < params.ball_count; ++place) {
        keys[place].ball_id = before[place].ball_id;
    }
    count_cells(keys.first(params.ball_count), cell_ranges, used_tiles, tickets, status);
}

template uvec3 cell_coordinates(const SubstepParams<float>&, const Vec3<float>&);
template uvec3 cell_coordinates(const SubstepParams<double>&, const Vec3<double>&);
template void assign_cells(const SubstepParams<float>&, std::span<const Vec4<float>>, std::span<Key>, Status&,
                           BallRange);
template void assign_cells(const SubstepParams<double>&, std::span<const Vec4<double>>, std::span<Key>, Status&,
                           BallRange);
template void assign_and_count(const SubstepParams<float>&, std::span<const Vec4<float>>, std::span<Key>,
                               std::span<CellRange>, std::span<std::uint32_t>, std::span<std::uint32_t>, Status&);
template void assign_and_count(const SubstepParams<double>&, std::span<const Vec4<double>>, std::span<Key>,
                               std::span<CellRange>, std::span<std::uint32_t>, std::span<std::uint32_t>, Status&);

}  // namespace ballpit::cpu
