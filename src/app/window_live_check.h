// The check of each stage while the window steps or runs: stands in for the backend's run, and keeps what the substep
// that ran last has shown.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "app/window_session.h"
#include "cpu/cpu_backend.h"
#include "measure/stage_checker.h"
#include "ui/live_check.h"

namespace ballpit::app {

class LiveCheck {
public:
    /// The session must outlive it.
    explicit LiveCheck(Session& session) : session_(session) {}

    ui::LiveCheckMode mode() const { return mode_; }
    /// Switched on, the part of the substep that has run runs again, under the check.
    void set_mode(ui::LiveCheckMode mode);

    /// Whose differences the table shows.
    void show(std::optional<Stage> stage) { shown_ = stage; }
    std::optional<Stage> shown() const { return shown_; }

    /// The spans hold until the simulation runs again.
    void describe(ui::LiveCheckState& state);

private:
    using Counts = std::array<std::array<std::uint32_t, slot_count>, stage_count>;

    void run(const Schedule& schedule, const SubstepParams<double>& params, std::size_t first, std::size_t last);
    void begin_substep();
    bool holds_for_place() const;
    ui::StageCheck stage_check(Stage stage) const;
    bool compares() const;

    Session& session_;
    cpu::CpuBackend<float> mirror_;
    std::optional<measure::StageChecker> checker_;
    ui::LiveCheckMode mode_ = ui::LiveCheckMode::off;
    std::optional<Stage> shown_;
    Counts writes_{};                        // dispatches that wrote a slot, by stage
    std::array<bool, stage_count> ended_{};  // stages that have run to their end
    Moment moment_;
    std::uint32_t ran_ = 0;  // as the stepper counts
    std::uint64_t layout_ = 0;
    double ms_ = 0.0;
    double last_ms_ = 0.0;
};

}  // namespace ballpit::app
