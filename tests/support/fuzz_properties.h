// What must hold of every scene, however extreme: each is a function that says what is wrong, or nothing.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/ball_state.h"
#include "core/features.h"
#include "core/layout.h"
#include "core/substep_params.h"
#include "measure/energy.h"
#include "measure/neighbours.h"

namespace ballpit::test {

using Complaint = std::optional<std::string>;

/// One substep from outside: states as they are computed with, and what was counted until then.
struct SeenSubstep {
    BallState before;
    BallState after;
    Status status_before{};
    Status status_after{};
    SubstepParams<double> params;
    Features features;
    bool assigned = false;  // balls were assigned to cells in this substep
};

/// Every ball is still there, with its own radius and its own mass, bit for bit; none leaves quarantine.
Complaint balls_exchanged(const SeenSubstep& seen);

/// With diagnostics every number is finite afterwards, and each ball that is newly in quarantine was counted.
Complaint lost_in_silence(const SeenSubstep& seen);

/// No ball is lost (not finite, or put into quarantine) whose next position and velocity, by the largest force that the
/// contact law could have, stay well within float.
Complaint lost_without_cause(const SeenSubstep& seen);

/// With diagnostics, where a grid is built: balls outside the box at the start of the substep were counted, and no
/// others.
Complaint outside_in_silence(const SeenSubstep& seen);

/// The grid finds every touching pair, by comparing each ball with each other.
Complaint pairs_missed(const measure::GridView& view);

/// Energies at two moments between which nothing put energy in but rounding, at most so many J.
Complaint energy_grew(const measure::Totals& start, const measure::Totals& now, double rounding = 0.0);

/// J, by which a step of the floats changes the heights of all balls (gravity in m/s^2).
double rounding_of_heights(const BallState& state, const dvec3& gravity);

/// Hashes of the same moment in two runs.
Complaint hashes_differ(std::uint64_t first, std::uint64_t second);

}  // namespace ballpit::test
