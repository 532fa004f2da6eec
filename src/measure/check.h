// Every dispatch on one backend against the mirror on the same input: names the first stage that differs.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/simulation.h"
#include "measure/comparison.h"

namespace ballpit::measure {

/// What became of one slot that one stage writes, summed over all dispatches of that stage.
struct CheckRow {
    Stage stage{};
    Slot slot{};
    std::uint64_t elements = 0;
    std::uint64_t differing = 0;
    std::uint64_t beyond_bound = 0;
    std::uint64_t max_ulp = 0;
    double max_error = 0.0;
    double of_bound = 0.0;  // comparison.h
    std::string first;      // "substep 3, bitonic_sort k=8 j=2, slot 12: GPU (…), CPU (…)"
};

struct CheckReport {
    std::uint64_t steps = 0;
    std::uint64_t substeps = 0;
    std::uint64_t dispatches = 0;
    std::vector<CheckRow> rows;           // in the order of the stages
    std::vector<std::string> violations;  // invariants broken on the backend under test, the first few
    std::uint64_t violation_count = 0;

    bool passed() const;
};

/// Runs `steps` steps of the simulation. After each dispatch the slots it wrote are compared with `mirror`'s,
/// which then continues from the backend's bytes: a difference is reported where it arises, not where it
/// ends up. `progress` is called after each step.
CheckReport check(Simulation& simulation, Backend& mirror, std::uint64_t steps,
                  const std::function<void(std::uint64_t)>& progress = {});

}  // namespace ballpit::measure
