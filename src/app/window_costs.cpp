#include "app/window_costs.h"

#include "core/error.h"
#include "gl/error.h"

namespace ballpit::app {

namespace {

constexpr double slice_ms = 12.0;  // of a frame
constexpr std::uint32_t most_balls = 1u << 20;

}  // namespace

WindowCosts::Measured WindowCosts::to_measure(const Session& session) {
    const Simulation& simulation = session.simulation();
    Settings settings = simulation.settings();
    settings.pull.reset();
    settings.balls = 0;  // these two are what the curve is about
    settings.sort = Settings().sort;
    return {settings, session.scene_changes(), std::string(simulation.backend().name())};
}

void WindowCosts::start(Session& session) {
    const Simulation& simulation = session.simulation();
    try {
        curve_.emplace(
            measure::CostQuestion{simulation.scene(), simulation.settings(), simulation.seed(),
                                  measure::cost_counts(simulation.scene(), most_balls), measure::cost_sorts()},
            session.twin_backend());
        measured_ = to_measure(session);
        running_ = !curve_->done();
    } catch (const DeviceError& error) {
        message_ = error.what();
    }
}

void WindowCosts::update(bool open) {
    if (!working(open)) {
        return;
    }
    const auto failed = [this](const std::exception& error) {
        message_ = std::string(error.what()) + " No more balls are measured.";
        running_ = false;
    };
    try {
        running_ = curve_->advance(slice_ms);
    } catch (const DeviceError& error) {
        failed(error);
    } catch (const gl::Error& error) {
        failed(error);
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
