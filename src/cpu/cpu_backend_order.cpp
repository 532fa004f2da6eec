// What CpuBackend does where balls stay in the order of their cells: the dispatches that differ then. The laws do not,
// so collide and count_missed put the balls back into the order of ids, do what they always do, and put the result in
// order.
#include <algorithm>
#include <cassert>

#include "cpu/assign_cells.h"
#include "cpu/count_missed.h"
#include "cpu/cpu_backend.h"
#include "cpu/order_keys.h"
#include "cpu/put_back.h"
#include "cpu/scatter_keys.h"

namespace ballpit::cpu {

namespace {

template <class T>
std::vector<T> by_ball(std::span<const Key> keys, const std::vector<T>& kept) {
    std::vector<T> values(kept.size(), T(0));
    put_back<T>(keys, kept, values);
    return values;
}

}  // namespace

template <class Real>
void CpuBackend<Real>::run_in_order(const Dispatch& dispatch, const SubstepParams<Real>& params) {
    const Features features = dispatch.program.features;
    Status& status = status_for(features);
    const std::span<Key> keys = ball_keys();
    switch (dispatch.program.shader) {
        case Shader::assign_cells:
            return assign_and_count<Real>(params, next_positions_, keys_, cell_ranges_, used_tiles_, tickets_, status);
        case Shader::scatter_keys:
            return scatter_kept_keys(keys, cell_ranges_, tickets_, scattered_keys_, origins_);
        case Shader::order_keys:
            return order_keys_and_state<Real>(scattered_keys_, origins_, cell_ranges_, next_positions_,
                                              next_velocities_, keys, sorted_positions_, sorted_velocities_);
        case Shader::count_missed:
            return count_missed<Real>(params, features, by_ball<Vec4<Real>>(keys, sorted_positions_), built_positions_,
                                      keys_, cell_ranges_, status);
        case Shader::keep_places:
            return put_back<Vec4<Real>>(keys, sorted_positions_, built_positions_);
        case Shader::collide:
            return collide_in_order(dispatch, params, status);
        default:
            assert(false);
    }
}

template <class Real>
void CpuBackend<Real>::collide_in_order(const Dispatch& dispatch, const SubstepParams<Real>& params, Status& status) {
    const std::span<const Key> keys = ball_keys();
    const auto positions = by_ball<Vec4<Real>>(keys, sorted_positions_);
    const auto velocities = by_ball<Vec4<Real>>(keys, sorted_velocities_);
    std::vector<Vec4<Real>> next_positions = positions;
    std::vector<Vec4<Real>> next_velocities = velocities;
    collide<Real>(params, dispatch.program.features, {positions, velocities, damping_ratios_, keys_, cell_ranges_},
                  {next_positions, next_velocities, left_out_}, status, {0, params.ball_count});
    put_in_order<Vec4<Real>>(keys, next_positions, next_positions_);
    put_in_order<Vec4<Real>>(keys, next_velocities, next_velocities_);
}

template void CpuBackend<float>::collide_in_order(const Dispatch&, const SubstepParams<float>&, Status&);
template void CpuBackend<double>::collide_in_order(const Dispatch&, const SubstepParams<double>&, Status&);
template void CpuBackend<float>::run_in_order(const Dispatch&, const SubstepParams<float>&);
template void CpuBackend<double>::run_in_order(const Dispatch&, const SubstepParams<double>&);

}  // namespace ballpit::cpu
