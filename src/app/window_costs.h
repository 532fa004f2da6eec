// Cost against the number of balls in the window: measured a slice a frame while its window is open, and stays.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "app/measured_run.h"
#include "measure/cost_curve.h"
#include "ui/costs.h"

namespace ballpit::app {

class WindowCosts {
public:
    /// Begins anew, with the scene and the settings as they are, on a backend of its own.
    void start(Session& session);
    /// What was measured stays.
    void stop() { running_ = false; }

    /// Once a frame.
    void update(bool open);
    bool working(bool open) const { return open && running_; }

    /// Null while closed; valid until the next call.
    const ui::CostsState* describe(const Session& session, bool open);
    std::string take_message() { return std::exchange(message_, {}); }

private:
    // What a curve holds for.
    static MeasuredRun to_measure(const Session& session);

    std::optional<measure::CostCurve> curve_;
    std::optional<MeasuredRun> measured_;
    bool running_ = false;
    ui::CostsState state_;
    std::string message_;
};

}  // namespace ballpit::app
