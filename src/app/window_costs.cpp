#include "app/window_costs.h"

namespace ballpit::app {

namespace {

constexpr double slice_ms = 12.0;  // of a frame
constexpr std::uint32_t most_balls = 1u << 20;

}  // namespace

MeasuredRun WindowCosts::to_measure(const Session& session) {
    Settings settings = session.simulation().settings();
    settings.balls = 0;  // these two are what the curve is about
    settings.sort = Settings().sort;
    return measured_run(session, settings);
}

void WindowCosts::start(Session& session) {
    const Simulation& simulation = session.simulation();
    const auto failure = device_failure([&] {
        curve_.emplace(
            measure::CostQuestion{simulation.scene(), simulation.settings(), simulation.seed(),
                                  measure::cost_counts(simulation.scene(), most_balls), measure::cost_sorts()},
            session.twin_backend());
        measured_ = to_measure(session);
        running_ = !curve_->done();
    });
    message_ = failure.value_or(message_);
}

void WindowCosts::update(bool open) {
    if (!working(open)) {
        return;
    }
    if (const auto failure = device_failure([this] { running_ = curve_->advance(slice_ms); })) {
        message_ = *failure + " No more balls are measured.";
        running_ = false;
    }
}

const ui::CostsState* WindowCosts::describe(const Session& session, bool open) {
    if (!open) {
        return nullptr;
    }
    const Simulation& simulation = session.simulation();
    state_.possible = !measure::cost_counts(simulation.scene(), most_balls).empty();
    state_.running = running_;
    state_.here_balls = simulation.settings().balls;
    state_.here_sort = setting_text(*find_setting("sort"), simulation.settings());
    if (!curve_) {
        return &state_;
    }
    state_.begun = true;
    state_.stale = measured_ != to_measure(session);
    state_.progress = curve_->progress();
    state_.lines.clear();
    for (const std::string& sort : curve_->question().sorts) {
        state_.lines.push_back({sort, curve_->points(sort)});
    }
    return &state_;
}

}  // namespace ballpit::app
