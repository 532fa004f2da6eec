#include "measure/check.h"

#include <algorithm>
#include <cstring>
#include <ranges>

#include "measure/float_bound.h"
#include "measure/invariants.h"

namespace ballpit::measure {

namespace {

constexpr std::size_t violations_kept = 10;

class Checker {
public:
    Checker(Simulation& simulation, Backend& mirror)
        : simulation_(simulation), backend_(simulation.backend()), mirror_(mirror) {
        mirror_.load(simulation.raw_state(), simulation.schedule(), simulation.settings().limit_force);
        mirror_.write(Slot::status, backend_.read(Slot::status));
    }

    void substep() {
        const Schedule& schedule = simulation_.schedule();
        const SubstepParams<double> params = simulation_.params();
        for (std::size_t i = 0; i < schedule.dispatches.size(); ++i) {
            backend_.run(schedule, params, i, i + 1);
            mirror_.run(schedule, params, i, i + 1);
            compare(schedule.dispatches[i], params);
            const bool stage_ends =
                i + 1 == schedule.dispatches.size() || schedule.dispatches[i + 1].stage != schedule.dispatches[i].stage;
            if (stage_ends) {
                check_invariant(schedule, schedule.dispatches[i].stage);
            }
            ++report.dispatches;
        }
        simulation_.end_substep();
        mirror_.swap_states();
        ++report.substeps;
    }

    CheckReport report;

private:
    void compare(const Dispatch& dispatch, const SubstepParams<double>& params) {
        for (const Slot slot : dispatch.writes) {
            const Bytes ours = backend_.read(slot);
            const Bytes theirs = mirror_.read(slot);
            CheckRow& row = row_of(dispatch.stage, slot);
            row.elements += element_count(slot, ours);
            if (ours == theirs) {
                continue;
            }
            const Comparison difference = compare_slot(slot, ours, theirs, bounds(slot, dispatch, params));
            add(row, difference, dispatch);
            mirror_.write(slot, ours);
        }
    }

    // Only collide writes floats; its bound follows from the state that it read.
    std::vector<double> bounds(Slot slot, const Dispatch& dispatch, const SubstepParams<double>& params) {
        if (dispatch.stage != Stage::collide || slot == Slot::status) {
            return {};
        }
        CollideBound bound = collide_bound(
            params, dispatch.program.features, read_slot<vec4>(backend_, Slot::positions),
            read_slot<vec4>(backend_, Slot::velocities), read_slot<float>(backend_, Slot::damping_ratios));
        return slot == Slot::next_positions ? bound.position : bound.velocity;
    }

    void add(CheckRow& row, const Comparison& difference, const Dispatch& dispatch) const {
        if (row.first.empty() || (row.beyond_bound == 0 && difference.beyond_bound != 0)) {
            row.first = "substep " + std::to_string(report.substeps) + ", " + dispatch.name + ", " + difference.first;
        }
        row.differing += difference.differing;
        row.beyond_bound += difference.beyond_bound;
        row.max_ulp = std::max(row.max_ulp, difference.max_ulp);
        row.max_error = std::max(row.max_error, difference.max_error);
        row.of_bound = std::max(row.of_bound, difference.of_bound);
    }

    CheckRow& row_of(Stage stage, Slot slot) {
        const auto found = std::ranges::find_if(
            report.rows, [&](const CheckRow& row) { return row.stage == stage && row.slot == slot; });
        if (found != report.rows.end()) {
            return *found;
        }
        CheckRow row;
        row.stage = stage;
        row.slot = slot;
        return report.rows.emplace_back(std::move(row));
    }

    Violation violation_of(const Schedule& schedule, Stage stage) {
        const auto keys = read_slot<Key>(backend_, Slot::keys);
        switch (stage) {
            case Stage::assign_cells:
                return keys_assigned(keys, schedule.ball_count, schedule.cell_count);
            case Stage::bitonic_sort:
                return keys_sorted(keys, schedule.ball_count);
            case Stage::build_grid:
                return ranges_partition(read_slot<CellRange>(backend_, Slot::cell_ranges), keys, schedule.ball_count);
            case Stage::collide:
                break;
        }
        return all_finite(read_slot<vec4>(backend_, Slot::next_positions),
                          read_slot<vec4>(backend_, Slot::next_velocities));
    }

    void check_invariant(const Schedule& schedule, Stage stage) {
        if (const Violation violation = violation_of(schedule, stage)) {
            ++report.violation_count;
            if (report.violations.size() < violations_kept) {
                report.violations.push_back("substep " + std::to_string(report.substeps) + ", after " +
                                            std::string(stage_name(stage)) + ": " + *violation);
            }
        }
    }

    Simulation& simulation_;
    Backend& backend_;
    Backend& mirror_;
};

}  // namespace

bool CheckReport::passed() const {
    return violation_count == 0 && std::ranges::all_of(rows, [](const CheckRow& row) { return row.beyond_bound == 0; });
}

CheckReport check(Simulation& simulation, Backend& mirror, std::uint64_t steps,
                  const std::function<void(std::uint64_t)>& progress) {
    Checker checker(simulation, mirror);
    for (std::uint64_t step = 0; step < steps; ++step) {
        for (std::uint32_t i = 0; i < simulation.settings().substeps; ++i) {
            checker.substep();
        }
        ++checker.report.steps;
        if (progress) {
            progress(checker.report.steps);
        }
    }
    return std::move(checker.report);
}

}  // namespace ballpit::measure
