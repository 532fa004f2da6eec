// Warnings of what physics or floats cannot do with these settings and balls (core/extremes.h has their names).
#pragma once

#include "core/ball_state.h"
#include "core/extremes.h"
#include "core/meter.h"
#include "core/simulation.h"

namespace ballpit::measure {

/// Each warning's number where its limit is passed. Without a record (of a meter) speeds are those of a fall over the
/// largest diameter, and the step is held against one contact alone: what that says is certain, a pile's limit is
/// lower.
ExtremeNumbers warnings_of(const Simulation& simulation, const MeterRecord* record);

/// The worse of both, number by number.
ExtremeNumbers worse_of(const ExtremeNumbers& a, const ExtremeNumbers& b);

/// J in the springs of balls that overlap, or overlap a wall, where some do by more than a tenth of the sum of their
/// radii (of the diameter at a wall); else 0.
double stored_in_overlaps(const BallState& state, const Settings& settings, Features features, const Box& box);

}  // namespace ballpit::measure
