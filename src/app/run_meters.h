// The meters of a run without a window: what was read on the way, and of the moment it is at.
#pragma once

#include "app/report.h"
#include "core/simulation.h"
#include "measure/energy_balance.h"

namespace ballpit::app {

class RunMeters {
public:
    /// What has arrived; never waits.
    void take(Simulation& simulation);
    /// The present moment, which needs metering on. Waits for the device.
    void read_now(Simulation& simulation);

    /// Of what was read last; needs a read_now() before.
    const MeterRecord& record() const { return balance_.last(); }
    const measure::Balance& balance() const { return *balance_.balance(); }

private:
    measure::EnergyBalance balance_;
};

/// Reading and gauges of the moment; where every substep was `metered`, the balance of the energy, too.
Json meters_json(const RunMeters& meters, const Simulation& simulation, bool metered);

}  // namespace ballpit::app
