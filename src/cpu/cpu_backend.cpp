#include "cpu/cpu_backend.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <type_traits>
#include <utility>

#include "core/contact.h"
#include "core/stopwatch.h"
#include "cpu/assign_cells.h"
#include "cpu/bitonic_sort.h"
#include "cpu/bitonic_sort_fused.h"
#include "cpu/bitonic_sort_strides.h"
#include "cpu/build_grid.h"
#include "cpu/clear_cells.h"
#include "cpu/count_cells.h"
#include "cpu/count_missed.h"
#include "cpu/count_tiles.h"
#include "cpu/gather.h"
#include "cpu/keep_places.h"
#include "cpu/meter.h"
#include "cpu/order_keys.h"
#include "cpu/put_back.h"
#include "cpu/scan_cells.h"
#include "cpu/scatter_keys.h"
#include "cpu/start_order.h"

namespace ballpit::cpu {

namespace {

template <class Real>
struct CpuState final : SavedState {
    using SavedState::SavedState;
    std::size_t bytes() const override {
        return (positions.size() + velocities.size()) * sizeof(Vec4<Real>) + left_out.size() * sizeof(LeftOut<Real>) +
               damping_ratios.size() * sizeof(Real) + built_positions.size() * sizeof(Vec4<Real>);
    }

    std::vector<Vec4<Real>> positions;
    std::vector<Vec4<Real>> velocities;
    std::vector<LeftOut<Real>> left_out;
    std::vector<Real> damping_ratios;
    std::vector<Vec4<Real>> built_positions;
    Status status{};
};

}  // namespace

template <class Real>
std::string CpuBackend<Real>::device() const {
    return std::is_same_v<Real, float> ? "CPU mirror (float, one thread)" : "CPU reference (double, one thread)";
}

template <class Real>
std::string CpuBackend<Real>::driver() const {
#if defined(__clang__)
    return "clang " __clang_version__;
#elif defined(__GNUC__)
    return "gcc " __VERSION__;
#else
    return "C++20 compiler";
#endif
}

template <class Real>
void CpuBackend<Real>::load(const BallState& state, const Schedule& schedule, bool limit_force) {
    positions_.assign(state.positions.begin(), state.positions.end());
    velocities_.assign(state.velocities.begin(), state.velocities.end());
    // Rounded to float for the reference too: it answers the same question as the mirror.
    const std::vector<float> ratios = damping_ratios_of(state.restitutions, limit_force);
    damping_ratios_.assign(ratios.begin(), ratios.end());
    load_left_out(state.compensations, schedule);
    status_ = {};
    make_next(schedule);
    reschedule(schedule);
}

// The other state buffer, filled as if nothing had moved; none where balls are computed in place.
template <class Real>
void CpuBackend<Real>::make_next(const Schedule& schedule) {
    next_positions_ = schedule.in_place ? std::vector<Vec4<Real>>() : positions_;
    next_velocities_ = schedule.in_place ? std::vector<Vec4<Real>>() : velocities_;
}

template <class Real>
void CpuBackend<Real>::reschedule(const Schedule& schedule) {
    requested_ = {};
    assert(schedule.in_place == next_positions_.empty() || schedule.ball_count == 0);
    keys_.assign(schedule.key_count, Key{SENTINEL, SENTINEL});
    cell_ranges_.assign(schedule.cell_count, CellRange{0, 0});
    built_positions_ = schedule.keeps_places ? positions_ : std::vector<Vec4<Real>>();
    const std::size_t copies = schedule.features.has(Feature::sorted_copies) ? schedule.ball_count : 0;
    sorted_positions_.assign(copies, Vec4<Real>(0));
    sorted_velocities_.assign(copies, Vec4<Real>(0));
    used_tiles_.assign(tile_count(schedule.cell_count), 0);
    const std::size_t counted = schedule.counts_cells ? schedule.ball_count : 0;
    tickets_.assign(counted, 0);
    scattered_keys_.assign(counted, Key{0, 0});
    origins_.assign(can_keep_order(schedule) ? schedule.ball_count : 0, 0);
    tile_counts_.assign(schedule.counts_cells ? used_tiles_.size() : 0, 0);
}

template <class Real>
CollideInput<Real> CpuBackend<Real>::collide_input() const {
    return {positions_, velocities_, damping_ratios_, keys_, cell_ranges_};
}

template <class Real>
CollideOutput<Real> CpuBackend<Real>::collide_output(Features features) {
    return features.has(Feature::contact) ? CollideOutput<Real>{next_positions_, next_velocities_, left_out_}
                                          : CollideOutput<Real>{positions_, velocities_, left_out_};
}

template <class Real>
void CpuBackend<Real>::run_dispatch(const Dispatch& dispatch, const SubstepParams<Real>& params) {
    const Features features = dispatch.program.features;
    if (features.has(Feature::kept_order)) {
        return run_in_order(dispatch, params);
    }
    Status& status = status_for(features);
    const std::span<Key> keys = ball_keys();
    switch (dispatch.program.shader) {
        case Shader::assign_cells:
            return assign_cells<Real>(params, positions_, keys_, status, {0, params.ball_count});
        case Shader::bitonic_sort:
            return bitonic_sort(keys_, dispatch.constants[0], dispatch.constants[1]);
        case Shader::bitonic_sort_fused:
            return bitonic_sort_fused(keys_, dispatch.constants[1], dispatch.constants[3]);
        case Shader::bitonic_sort_strides:
            return bitonic_sort_strides(keys_, dispatch.constants[0], dispatch.constants[1], dispatch.constants[2]);
        case Shader::clear_cells:
            return clear_cells(cell_ranges_, used_tiles_);
        case Shader::build_grid:
            return build_grid(keys, cell_ranges_, used_tiles_, status);
        case Shader::count_cells:
            return count_cells(keys, cell_ranges_, used_tiles_, tickets_, status);
        case Shader::count_tiles:
            return count_tiles(cell_ranges_, tile_counts_);
        case Shader::scan_cells:
            return scan_cells(cell_ranges_);
        case Shader::scatter_keys:
            return scatter_keys(keys, cell_ranges_, tickets_, scattered_keys_);
        case Shader::order_keys:
            return order_keys(scattered_keys_, cell_ranges_, keys);
        case Shader::count_missed:
            return count_missed<Real>(params, features, positions_, built_positions_, keys_, cell_ranges_, status);
        case Shader::keep_places:
            return keep_places<Real>(positions_, built_positions_);
        case Shader::gather:
            return gather<Real>(keys, positions_, velocities_, sorted_positions_, sorted_velocities_);
        case Shader::start_order:
            return start_order<Real>(positions_, velocities_, next_positions_, next_velocities_, keys);
        case Shader::put_back:
            put_back<Vec4<Real>>(keys, next_positions_, positions_);
            return put_back<Vec4<Real>>(keys, next_velocities_, velocities_);
        case Shader::collide:
            return collide<Real>(params, features, collide_input(), collide_output(features), status,
                                 {0, params.ball_count});
    }
}

template <class Real>
void CpuBackend<Real>::run(const Schedule& schedule, const SubstepParams<double>& params, std::size_t first,
                           std::size_t last) {
    const auto narrow = narrowed<Real>(params);
    const bool whole = first == 0 && last == schedule.dispatches.size();
    StageTimes times{};
    for (std::size_t i = first; i < last; ++i) {
        const auto start = std::chrono::steady_clock::now();
        if (whole) {
            run_in_whole(schedule.dispatches[i], narrow);
        } else {
            run_dispatch(schedule.dispatches[i], narrow);
        }
        times[static_cast<std::size_t>(schedule.dispatches[i].stage)] += milliseconds_since(start);
    }
    if (timing_ && whole) {
        times_.push_back(times);
    }
}

template <class Real>
void CpuBackend<Real>::swap_states() {
    positions_.swap(next_positions_);
    velocities_.swap(next_velocities_);
}

template <class Real>
std::unique_ptr<SavedState> CpuBackend<Real>::save() {
    auto state = std::make_unique<CpuState<Real>>(static_cast<std::uint32_t>(positions_.size()));
    state->positions = positions_;
    state->velocities = velocities_;
    state->left_out = left_out_;
    state->damping_ratios = damping_ratios_;
    state->built_positions = built_positions_;
    state->status = status_;
    return state;
}

template <class Real>
void CpuBackend<Real>::restore(const SavedState& state, const Schedule& schedule) {
    const auto& saved = dynamic_cast<const CpuState<Real>&>(state);
    positions_ = saved.positions;
    velocities_ = saved.velocities;
    left_out_ = saved.left_out;
    left_out_.resize(schedule.features.has(Feature::compensated) ? positions_.size() : 0);
    damping_ratios_ = saved.damping_ratios;
    status_ = saved.status;
    make_next(schedule);
    reschedule(schedule);
    if (built_positions_.size() == saved.built_positions.size()) {  // saved under a schedule that keeps them, too
        built_positions_ = saved.built_positions;
    }
}

template <class Real>
void CpuBackend<Real>::request_hash(std::uint64_t tag) {
    if constexpr (std::is_same_v<Real, float>) {
        hashes_.push_back({tag, hash_state(positions_, velocities_)});
    } else {
        hashes_.push_back({tag, hash_state(typed<vec4>(read(Slot::positions)), typed<vec4>(read(Slot::velocities)))});
    }
}

template <class Real>
std::vector<TaggedHash> CpuBackend<Real>::take_hashes() {
    return std::exchange(hashes_, {});
}

template <class Real>
void CpuBackend<Real>::request_reading(std::uint64_t tag, const Schedule& schedule, const SubstepParams<double>& params,
                                       const Synchronisation& synchronisation) {
    const auto start = std::chrono::steady_clock::now();
    readings_.push_back(
        {tag, meter<Real>(narrowed<Real>(params), schedule.features, synchronisation,
                          {positions_, velocities_, next_velocities_, damping_ratios_, keys_, cell_ranges_})});
    reading_times_.push_back(milliseconds_since(start));
}

template <class Real>
std::vector<TaggedReading> CpuBackend<Real>::take_readings() {
    return std::exchange(readings_, {});
}

template <class Real>
std::vector<double> CpuBackend<Real>::take_reading_times() {
    return std::exchange(reading_times_, {});
}

template <class Real>
std::vector<StageTimes> CpuBackend<Real>::take_times() {
    return std::exchange(times_, {});
}

template class CpuBackend<float>;
template class CpuBackend<double>;

}  // namespace ballpit::cpu
