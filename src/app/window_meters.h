// The meters in the window: while their panel is open every substep is metered, and what has arrived is added up.
#pragma once

#include <deque>

#include "app/window_session.h"
#include "ui/meters.h"
#include "ui/state.h"

namespace ballpit::app {

class WindowMeters {
public:
    /// The balance begins with the next record.
    void restart();
    /// Once a frame; never waits. Closed, nothing is metered or kept.
    void update(Session& session, bool open);
    /// Null while closed; valid until the next call.
    const ui::MetersState* describe(const Session& session, bool open);

private:
    void close();

    measure::EnergyBalance balance_;
    measure::BalanceSeries series_;
    std::deque<double> times_;  // ms, of the last readings
    bool asked_ = false;        // for the very first moment, which no substep has metered
    ui::MetersState state_;
};

}  // namespace ballpit::app
