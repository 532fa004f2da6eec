// The error budget in the window: after every change of scene or settings the probe of single collisions runs again, on
// a backend of its own, a slice a frame; then the count that would meet the budget. Closed, nothing runs or is kept.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/window_meters.h"
#include "app/window_session.h"
#include "measure/error_budget.h"
#include "ui/budget.h"

namespace ballpit::app {

class WindowBudget {
public:
    explicit WindowBudget(WindowMeters& meters) : meters_(meters) {}

    /// Once a frame. `now_s` of the window's clock; `frame_ms`: what a frame takes; `substep_ms`: what a substep takes,
    /// where it is known.
    void update(Session& session, bool open, double now_s, double frame_ms, std::optional<double> substep_ms);
    /// Whether there is something to do though nothing moves.
    bool working() const { return phase_ != Phase::idle || settling_; }

    void choose(const ui::BudgetOptions& options) { options_ = options; }
    const ui::BudgetOptions& options() const { return options_; }
    /// Null while closed; valid until the next call.
    const ui::BudgetState* describe(const Session& session, bool open);
    std::string take_message() { return std::exchange(message_, {}); }

private:
    // What the answer depends on; the state of the balls only changes it slowly.
    struct Asked {
        Settings settings;
        int scene_changes = 0;
        const Backend* backend = nullptr;
        ui::BudgetOptions options;
        friend bool operator==(const Asked&, const Asked&) = default;
    };
    enum class Phase : std::uint8_t { idle, reading, probing, choosing };

    Asked to_ask(const Session& session) const;
    void stop();
    void look(Session& session, double now_s);
    void start(Session& session);
    void work(Session& session, double slice_ms);
    bool read_state(Session& session);
    bool slice();

    WindowMeters& meters_;
    ui::BudgetOptions options_;
    std::optional<Asked> asked_;
    std::optional<Asked> wanted_;
    double wanted_since_s_ = 0.0;
    bool settling_ = false;
    Phase phase_ = Phase::idle;
    std::optional<Bytes> copy_;  // of the balls, while the reading of the same moment is on its way
    int patience_ = 0;           // frames
    std::unique_ptr<Backend> twin_;
    measure::BudgetQuestion question_;
    std::optional<measure::CollisionProbe> probe_;
    std::optional<measure::BudgetChooser> chooser_;
    ui::BudgetState state_;
    std::string message_;
};

}  // namespace ballpit::app
