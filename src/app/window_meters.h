// The meters in the window: while their panel is open every substep is metered, and what has arrived is added up.
#pragma once

#include <deque>
#include <optional>

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
    /// Asks for a reading of the present moment, open or not. Within a substep there is none to be had: what it needs
    /// is in use.
    void ask(Session& session);
    /// Whether what was asked for is still on its way.
    bool awaiting() const { return awaited_.has_value(); }
    /// What arrived since ask().
    const std::optional<MeterRecord>& answer() const { return answer_; }
    /// Null while closed; valid until the next call.
    const ui::MetersState* describe(const Session& session, bool open);

private:
    void close();
    void answer(const MeterRecord& record);

    measure::EnergyBalance balance_;
    measure::BalanceSeries series_;
    std::deque<double> times_;       // ms, of the last readings
    std::optional<double> awaited_;  // s, the time of the moment that was asked for
    std::optional<MeterRecord> answer_;
    bool asked_ = false;  // for the very first moment, which no substep has metered
    ui::MetersState state_;
};

}  // namespace ballpit::app
