// What a probe of single collisions must find, on whichever backend.
#pragma once

#include "core/backend.h"
#include "core/scene.h"
#include "measure/collision_probe.h"

namespace ballpit::test {

/// Canonical balls (1 kg, 0.1 m, k = 1e4 N/m) at 1 m/s that touch each other or a wall 1 m from the origin, without
/// loss, with leapfrog and `substeps` (not always whole) a contact.
measure::ProbeQuestion canonical_question(bool wall, double substeps_a_contact);
measure::ProbeQuestion damped_question(double damping_ratio, bool limit_force, double substeps_a_contact);

/// Of the scene at its start with `balls` of them.
measure::ProbeQuestion question_of(const Scene& scene, std::uint32_t balls);

void probe_finds_elastic_errors(Backend& backend);
void probe_finds_historical_gain(Backend& backend);
void probe_finds_damped_restitution(Backend& backend);

/// Whether the damped restitution is where leapfrog must have it: what the case above asks, as a number.
bool damped_mean_is_right(Backend& backend);

}  // namespace ballpit::test
