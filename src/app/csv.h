// The two CSV files of `headless`: the final state, and one row a step.
#pragma once

#include <ostream>

#include "core/ball_state.h"
#include "core/meter.h"
#include "measure/energy.h"
#include "measure/energy_balance.h"

namespace ballpit::app {

/// Header id,x,y,z,vx,vy,vz,radius,mass; numbers read back as the same floats.
void write_state(std::ostream& out, const BallState& state);

/// Scenes of at most this many balls have every ball in the trace.
inline constexpr std::uint32_t traced_balls = 64;

void write_trace_header(std::ostream& out, std::uint32_t balls);

/// What the meters have of the moment of a row.
struct TracedMeters {
    measure::Balance balance;
    MeterReading reading;
    double dt_over_critical = 0.0;
};
void write_trace_row(std::ostream& out, std::uint64_t step, double time, const measure::Totals& totals,
                     const BallState& state, const TracedMeters& meters);

}  // namespace ballpit::app
