#include "support/fuzz_stages.h"

#include <algorithm>

#include "core/quarantine.h"
#include "measure/invariants.h"
#include "measure/momentum.h"
#include "measure/stage_checker.h"

namespace ballpit::test {

namespace {

void check_stage(Simulation& simulation, const Dispatch& dispatch, const BallState& before, const std::string& place) {
    Backend& backend = simulation.backend();
    const Schedule& schedule = simulation.schedule();
    if (dispatch.stage == Stage::collide) {
        if (!simulation.builds_grid()) {
            return;  // an old grid may show one ball to another and not the other to it: counted as missed
        }
        const bool in_place = schedule.in_place;
        const auto positions = read_slot<vec4>(backend, in_place ? Slot::positions : Slot::next_positions);
        if (any_enters_quarantine(before.positions, positions)) {
            return;
        }
        require(
            "momentum comes from outside",
            measure::momentum_balanced(simulation.params(), dispatch.program.features, before.positions,
                                       before.velocities, read_slot<float>(backend, Slot::damping_ratios),
                                       read_slot<vec4>(backend, in_place ? Slot::velocities : Slot::next_velocities),
                                       before.compensations),
            place);
        return;
    }
    auto keys = read_slot<Key>(backend, Slot::keys);
    if (dispatch.stage == Stage::assign_cells) {
        require("every key is of the grid", measure::keys_assigned(keys, schedule.ball_count, schedule.cell_count),
                place);
    } else if (dispatch.stage == Stage::bitonic_sort) {
        require("keys are sorted", measure::keys_sorted(keys, schedule.ball_count), place);
    } else {
        if (dispatch.stage == Stage::counting_sort) {
            require("keys are sorted", measure::keys_sorted(keys, schedule.ball_count), place);
        } else if (schedule.counts_cells) {
            std::sort(keys.begin(), keys.begin() + schedule.ball_count,
                      [](const Key& a, const Key& b) { return a < b; });  // the sort comes next
        }
        const auto ranges = read_slot<CellRange>(backend, Slot::cell_ranges);
        require("ranges partition the slots", measure::ranges_partition(ranges, keys, schedule.ball_count), place);
        if (simulation.settings().cell_factor >= 1.0) {
            require("the grid finds every pair", pairs_missed({before.positions, keys, ranges, schedule.grid}), place);
        }
    }
}

void compare(const measure::StageChecker& checker, const std::string& place) {
    for (const measure::CheckRow& row : checker.rows()) {
        require("the GPU agrees with the mirror", row.beyond_bound == 0 ? Complaint() : Complaint(row.first), place);
    }
}

}  // namespace

void require(const char* property, const Complaint& complaint, const std::string& place) {
    if (complaint) {
        throw Stop{{property, place + ": " + *complaint}};
    }
}

void run_dispatches(Simulation& simulation, const BallState& before, const FuzzBackends& backends,
                    const std::string& place) {
    const Schedule& schedule = simulation.schedule();
    if (simulation.still() && schedule.in_place) {
        return;  // no time: nothing may be overwritten
    }
    const std::unique_ptr<Backend> mirror = backends.mirror ? backends.mirror() : nullptr;
    std::optional<measure::StageChecker> checker;
    if (mirror != nullptr) {
        checker.emplace(simulation.backend(), *mirror);
        checker->load(before, schedule, simulation.settings().limit_force);
    }
    for (std::size_t first = 0; first < schedule.dispatches.size();) {
        std::size_t last = first + 1;
        while (last < schedule.dispatches.size() &&
               schedule.dispatches[last].stage == schedule.dispatches[first].stage) {
            ++last;
        }
        if (checker) {
            checker->run(schedule, simulation.params(), first, last);
            compare(*checker, place);
        } else {
            simulation.backend().run(schedule, simulation.params(), first, last);
        }
        check_stage(simulation, schedule.dispatches[last - 1], before, place);
        first = last;
    }
}

}  // namespace ballpit::test
