#include "cpu/assign_cells.h"

#include <algorithm>
#include <cmath>

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

template uvec3 cell_coordinates(const SubstepParams<float>&, const Vec3<float>&);
template uvec3 cell_coordinates(const SubstepParams<double>&, const Vec3<double>&);
template void assign_cells(const SubstepParams<float>&, std::span<const Vec4<float>>, std::span<Key>, Status&,
                           BallRange);
template void assign_cells(const SubstepParams<double>&, std::span<const Vec4<double>>, std::span<Key>, Status&,
                           BallRange);

}  // namespace ballpit::cpu
