#include "measure/check.h"

#include <algorithm>

namespace ballpit::measure {

bool CheckReport::passed() const {
    return violation_count == 0 && std::ranges::all_of(rows, [](const CheckRow& row) { return row.beyond_bound == 0; });
}

CheckReport check(Simulation& simulation, Backend& mirror, std::uint64_t steps,
                  const std::function<void(std::uint64_t)>& progress) {
    StageChecker checker(simulation.backend(), mirror);
    checker.load(simulation.raw_state(), simulation.schedule(), simulation.settings().limit_force);
    std::uint64_t builds = 0;
    for (std::uint64_t step = 0; step < steps; ++step) {
        for (std::uint32_t i = 0; i < simulation.settings().substeps; ++i) {
            // Every other build as it runs where balls stay in the order of their cells.
            builds += simulation.builds_grid() ? 1 : 0;
            const bool kept = can_keep_order(simulation.schedule()) && simulation.builds_grid() && builds % 2 == 0;
            const Schedule schedule = kept ? there_and_back(simulation.schedule()) : simulation.schedule();
            checker.run(schedule, simulation.params(), 0, schedule.dispatches.size());
            checker.end_substep(schedule);
            simulation.end_substep(schedule);
        }
        if (progress) {
            progress(step + 1);
        }
    }
    return {steps,          checker.substeps(),   checker.dispatches(),
            checker.rows(), checker.violations(), checker.violation_count()};
}

}  // namespace ballpit::measure
