// One substep of the property fuzz, stage by stage.
#pragma once

#include <string>

#include "core/simulation.h"
#include "support/fuzz_properties.h"
#include "support/fuzz_run.h"

namespace ballpit::test {

// Leaves a run where a property does not hold.
struct Stop {
    FuzzFailure failure;
};

/// Throws Stop where there is a complaint.
void require(const char* property, const Complaint& complaint, const std::string& place);

/// All dispatches of the present substep, from the state `before`; a broken stage is found before the next one works
/// with what it left. Compares with the mirror where there is one.
void run_dispatches(Simulation& simulation, const BallState& before, const FuzzBackends& backends,
                    const std::string& place);

}  // namespace ballpit::test
