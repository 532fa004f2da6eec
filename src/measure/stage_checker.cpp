#include "measure/stage_checker.h"

#include <algorithm>
#include <utility>

#include "core/quarantine.h"
#include "measure/any_order.h"
#include "measure/float_bound.h"
#include "measure/invariants.h"
#include "measure/momentum.h"
#include "measure/slot_table.h"

namespace ballpit::measure {

namespace {

constexpr std::size_t violations_kept = 10;

bool writes(const Dispatch& dispatch, Slot slot) {
    return std::ranges::find(dispatch.writes, slot) != dispatch.writes.end();
}

bool is_position(Slot slot) { return slot == Slot::positions || slot == Slot::next_positions; }

std::vector<double> in_order_of(std::span<const Key> keys, std::span<const double> by_ball) {
    std::vector<double> ordered(by_ball.size());
    for (std::size_t slot = 0; slot < ordered.size(); ++slot) {
        ordered[slot] = by_ball[keys[slot].ball_id];
    }
    return ordered;
}

Violation violation_after(Backend& backend, const Schedule& schedule, const Dispatch& dispatch,
                          const SubstepParams<double>& params, const BallState& before) {
    if (dispatch.stage == Stage::collide) {
        const bool in_place = writes(dispatch, Slot::positions);
        const auto positions = read_slot<vec4>(backend, in_place ? Slot::positions : Slot::next_positions);
        const auto velocities = read_slot<vec4>(backend, in_place ? Slot::velocities : Slot::next_velocities);
        if (Violation violation = all_finite(positions, velocities)) {
            return violation;
        }
        if (any_enters_quarantine(before.positions, positions)) {
            return std::nullopt;
        }
        return momentum_balanced(params, schedule.features, before.positions, before.velocities,
                                 read_slot<float>(backend, Slot::damping_ratios), velocities, before.compensations);
    }
    auto keys = read_slot<Key>(backend, Slot::keys);
    switch (dispatch.stage) {
        case Stage::assign_cells:
            return keys_assigned(keys, schedule.ball_count, schedule.cell_count);
        case Stage::bitonic_sort:
            return keys_sorted(keys, schedule.ball_count);
        case Stage::counting_sort:
            if (Violation violation = keys_sorted(keys, schedule.ball_count)) {
                return violation;
            }
            break;
        case Stage::build_grid:
            if (schedule.counts_cells) {
                std::sort(keys.begin(), keys.begin() + schedule.ball_count,
                          [](const Key& a, const Key& b) { return a < b; });  // the sort comes next
            }
            break;
        case Stage::collide:
            break;
    }
    return ranges_partition(read_slot<CellRange>(backend, Slot::cell_ranges), keys, schedule.ball_count);
}

}  // namespace

void StageChecker::load(const BallState& state, const Schedule& schedule, bool limit_force) {
    if (mirror_ != nullptr) {
        mirror_->load(state, schedule, limit_force);
        // The grid as well: it may be used by more than one substep.
        for (const Slot slot : {Slot::status, Slot::keys, Slot::cell_ranges, Slot::used_tiles, Slot::built_positions}) {
            mirror_->write(slot, backend_.read(slot));
        }
    }
}

void StageChecker::run(const Schedule& schedule, const SubstepParams<double>& params, std::size_t first,
                       std::size_t last) {
    BallState before;
    for (std::size_t i = first; i < last; ++i) {
        const Dispatch& dispatch = schedule.dispatches[i];
        // Before the first of the stage: collide may work in place, and changes what sums have left out.
        if (dispatch.stage == Stage::collide && (i == first || schedule.dispatches[i - 1].stage != Stage::collide)) {
            before.positions = read_slot<vec4>(backend_, Slot::positions);
            before.velocities = read_slot<vec4>(backend_, Slot::velocities);
            before.compensations = read_slot<Compensation>(backend_, Slot::compensations);
        }
        backend_.run(schedule, params, i, i + 1);
        if (mirror_ != nullptr) {
            mirror_->run(schedule, params, i, i + 1);
            compare(dispatch, params, before);
        }
        if (i + 1 == schedule.dispatches.size() || schedule.dispatches[i + 1].stage != dispatch.stage) {
            check_invariant(schedule, dispatch, params, before);
        }
        ++dispatches_;
    }
}

void StageChecker::end_substep(const Schedule& schedule) {
    if (mirror_ != nullptr && schedule.swaps_states) {
        mirror_->swap_states();
    }
    ++substeps_;
}

void StageChecker::clear() {
    rows_.clear();
    bytes_ = {};
    violations_.clear();
    stage_violations_ = {};
    violation_count_ = 0;
    substeps_ = 0;
    dispatches_ = 0;
}

void StageChecker::compare(const Dispatch& dispatch, const SubstepParams<double>& params, const BallState& before) {
    for (const Slot slot : dispatch.writes) {
        const Bytes found = backend_.read(slot);
        const Bytes ours = in_mirror_order(slot, found);
        const Bytes computed = mirror_->read(slot);
        const Bytes theirs = in_mirror_order(slot, computed);
        CheckRow& row = row_of(dispatch.stage, slot);
        row.elements += element_count(slot, ours);
        if (found != computed) {
            mirror_->write(slot, found);
        }
        if (ours == theirs) {
            continue;
        }
        const Comparison difference = compare_slot(slot, ours, theirs, bounds(slot, dispatch, params, before));
        add(row, difference, dispatch);
        bytes_[static_cast<std::size_t>(slot)] = CheckedBytes{dispatch.name, ours, theirs, difference.places};
    }
}

Bytes StageChecker::in_mirror_order(Slot slot, const Bytes& bytes) {
    if (slot == Slot::tickets) {
        return tickets_in_order(bytes, read_slot<Key>(backend_, Slot::keys));
    }
    if (slot == Slot::origins) {
        return origins_in_order(bytes, read_slot<CellRange>(backend_, Slot::cell_ranges));
    }
    return any_order(slot) ? scattered_in_order(bytes, read_slot<CellRange>(backend_, Slot::cell_ranges)) : bytes;
}

// Only collide writes floats of its own; its bound follows from the state that it read.
std::vector<double> StageChecker::bounds(Slot slot, const Dispatch& dispatch, const SubstepParams<double>& params,
                                         const BallState& before) {
    if (dispatch.program.shader != Shader::collide || slot == Slot::status) {
        return {};
    }
    CollideBound bound = collide_bound(params, dispatch.program.features, before.positions, before.velocities,
                                       read_slot<float>(backend_, Slot::damping_ratios), before.compensations);
    if (slot == Slot::compensations) {
        return std::move(bound.compensation);
    }
    std::vector<double>& by_ball = is_position(slot) ? bound.position : bound.velocity;
    if (!dispatch.program.features.has(Feature::kept_order)) {
        return std::move(by_ball);
    }
    return in_order_of(read_slot<Key>(backend_, Slot::keys), by_ball);
}

void StageChecker::add(CheckRow& row, const Comparison& difference, const Dispatch& dispatch) const {
    if (row.first.empty() || (row.beyond_bound == 0 && difference.beyond_bound != 0)) {
        row.first = "substep " + std::to_string(substeps_) + ", " + dispatch.name + ", " + difference.first;
    }
    row.differing += difference.differing;
    row.beyond_bound += difference.beyond_bound;
    row.max_ulp = std::max(row.max_ulp, difference.max_ulp);
    row.max_error = std::max(row.max_error, difference.max_error);
    row.of_bound = std::max(row.of_bound, difference.of_bound);
}

CheckRow& StageChecker::row_of(Stage stage, Slot slot) {
    const auto found =
        std::ranges::find_if(rows_, [&](const CheckRow& row) { return row.stage == stage && row.slot == slot; });
    if (found != rows_.end()) {
        return *found;
    }
    CheckRow row;
    row.stage = stage;
    row.slot = slot;
    return rows_.emplace_back(std::move(row));
}

void StageChecker::check_invariant(const Schedule& schedule, const Dispatch& dispatch,
                                   const SubstepParams<double>& params, const BallState& before) {
    const Violation violation = violation_after(backend_, schedule, dispatch, params, before);
    if (!violation) {
        return;
    }
    ++violation_count_;
    stage_violations_[static_cast<std::size_t>(dispatch.stage)] = violation;
    if (violations_.size() < violations_kept) {
        violations_.push_back("substep " + std::to_string(substeps_) + ", after " +
                              std::string(stage_name(dispatch.stage)) + ": " + *violation);
    }
}

}  // namespace ballpit::measure
