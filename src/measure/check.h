// Every dispatch of some steps on a backend against the mirror.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/simulation.h"
#include "measure/stage_checker.h"

namespace ballpit::measure {

struct CheckReport {
    std::uint64_t steps = 0;
    std::uint64_t substeps = 0;
    std::uint64_t dispatches = 0;
    std::vector<CheckRow> rows;           // in the order of the stages
    std::vector<std::string> violations;  // invariants broken on the backend under test, the first few
    std::uint64_t violation_count = 0;

    bool passed() const;
};

/// Runs `steps` steps of the simulation dispatch by dispatch. `progress` is called after each step.
CheckReport check(Simulation& simulation, Backend& mirror, std::uint64_t steps,
                  const std::function<void(std::uint64_t)>& progress = {});

}  // namespace ballpit::measure
