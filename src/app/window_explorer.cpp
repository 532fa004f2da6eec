#include "app/window_explorer.h"

#include <algorithm>
#include <chrono>

#include "core/stopwatch.h"
#include "cpu/cpu_backend.h"
#include "measure/sweep_points.h"

namespace ballpit::app {

namespace {

constexpr double slice_ms = 12.0;  // of a frame
constexpr double run_seconds = 1.0;
constexpr double run_limit_s = 10.0;

using Clock = std::chrono::steady_clock;

std::optional<double> allowed(const measure::ErrorBudget& budget, measure::SweepMetric metric) {
    switch (metric) {
        case measure::SweepMetric::energy:
            return budget.energy;
        case measure::SweepMetric::restitution:
            return budget.restitution;
        case measure::SweepMetric::position:  // no budget has it
        case measure::SweepMetric::overlap:   // here the overlap itself, there its error
            break;
    }
    return std::nullopt;
}

}  // namespace

MeasuredRun WindowExplorer::to_measure(const Session& session) {
    Settings settings = measure::with_point(session.simulation().settings(), {});
    settings.cell_factor = Settings().cell_factor;  // each row has its own
    return measured_run(session, settings);
}

void WindowExplorer::start(Session& session) {
    const Simulation& simulation = session.simulation();
    measure::SweepQuestion question{simulation.scene(), simulation.settings(),
                                    simulation.seed(),  measure::sweep_points(simulation.settings(), {}),
                                    run_seconds,        run_limit_s};
    question.settings.balls -= simulation.added();  // thrown in: none of the scene's start
    const auto failure = device_failure([&] {
        sweep_.emplace(std::move(question),
                       measure::SweepBackends{[&session] { return session.twin_backend(); },
                                              [] { return std::make_unique<cpu::CpuBackend<double>>(); }});
        measured_ = to_measure(session);
        running_ = !sweep_->done();
        worked_ms_ = 0.0;
        waited_ms_ = 0.0;
    });
    message_ = failure.value_or(message_);
}

void WindowExplorer::update(bool open, double frame_ms) {
    if (!working(open)) {
        return;
    }
    waited_ms_ += frame_ms;
    const auto failure = device_failure([this] {
        const auto start = Clock::now();
        while (running_ && milliseconds_since(start) < slice_ms) {
            running_ = sweep_->advance(slice_ms);
        }
        worked_ms_ += milliseconds_since(start);
    });
    if (failure) {
        message_ = *failure + " The sweep ends here.";
        running_ = false;
    }
}

const ui::ExplorerState* WindowExplorer::describe(const Session& session, bool open,
                                                  const measure::ErrorBudget& budget) {
    if (!open) {
        return nullptr;
    }
    state_.running = running_;
    state_.budget = allowed(budget, state_.metric);
    state_.here = measure::point_of(session.simulation().settings());
    if (!sweep_) {
        return &state_;
    }
    state_.rows = sweep_->rows();
    state_.wanted = sweep_->question().points.size();
    state_.stale = measured_ != to_measure(session);
    state_.progress = sweep_->progress();
    // Only a share of every frame goes into the sweep.
    const auto left = sweep_->seconds_left();
    state_.seconds_left =
        left && worked_ms_ > 0.0 ? std::optional(*left * std::max(1.0, waited_ms_ / worked_ms_)) : std::nullopt;
    state_.dt = sweep_->question().settings.dt;
    state_.seconds = static_cast<double>(sweep_->steps()) * state_.dt;
    state_.float_floor = sweep_->float_floor();
    const measure::Reference& reference = sweep_->reference();
    state_.note = reference.note;
    state_.horizon_s =
        reference.usable() ? std::optional(static_cast<double>(*reference.steps) * state_.dt) : std::nullopt;
    return &state_;
}

}  // namespace ballpit::app
