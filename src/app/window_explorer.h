// Speed against accuracy in the window: a sweep that goes on a slice a frame while its window is open, and stays.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/measured_run.h"
#include "measure/error_budget.h"
#include "measure/sweep.h"
#include "ui/explorer.h"

namespace ballpit::app {

class WindowExplorer {
public:
    /// Begins anew, with the scene and the settings as they are; runs go from the start of the scene.
    void start(Session& session);
    /// What was measured stays.
    void stop() { running_ = false; }
    void choose(measure::SweepMetric metric) { state_.metric = metric; }

    /// Once a frame; `frame_ms`: what a frame takes.
    void update(bool open, double frame_ms);
    bool working(bool open) const { return open && running_; }

    /// Null while closed; valid until the next call. The budget's line is drawn where it allows what is plotted.
    const ui::ExplorerState* describe(const Session& session, bool open, const measure::ErrorBudget& budget);
    std::string take_message() { return std::exchange(message_, {}); }

private:
    // What a sweep holds for, beside the choices that it compares.
    static MeasuredRun to_measure(const Session& session);

    std::optional<measure::Sweep> sweep_;
    std::optional<MeasuredRun> measured_;
    bool running_ = false;
    double worked_ms_ = 0.0;
    double waited_ms_ = 0.0;
    ui::ExplorerState state_;
    std::string message_;
};

}  // namespace ballpit::app
