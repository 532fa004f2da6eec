#include "app/window_budget.h"

#include <algorithm>
#include <chrono>

#include "app/budget.h"
#include "app/measured_run.h"
#include "core/stopwatch.h"
#include "measure/budget_words.h"

namespace ballpit::app {

namespace {

constexpr double settle_s = 0.4;  // settings that are still being changed are not probed
// Of a frame, as laws are measured: a share of what it takes anyway, so that slow frames do not make it last for ever.
constexpr double share_of_frame = 0.15;
constexpr double least_ms = 3.0;
constexpr double most_ms = 20.0;
constexpr int most_patience = 30;            // frames that a reading may come later than the balls it is of
constexpr std::uint32_t slice_substeps = 8;  // between two looks at the clock

}  // namespace

// What a hand does to a ball does not change what a collision is.
WindowBudget::Asked WindowBudget::to_ask(const Session& session) const {
    Asked asked{session.simulation().settings(), session.scene_changes(), &session.simulation().backend(), options_};
    asked.settings.pull.reset();
    return asked;
}

void WindowBudget::stop() {
    chooser_.reset();
    probe_.reset();
    twin_.reset();
    copy_.reset();
    phase_ = Phase::idle;
    settling_ = false;
}

void WindowBudget::update(Session& session, bool open, double now_s, double frame_ms,
                          std::optional<double> substep_ms) {
    if (!open) {
        if (phase_ == Phase::reading) {
            session.simulation().backend().start_history(0);
        }
        stop();
        asked_.reset();
        wanted_.reset();
        state_ = {};
        return;
    }
    state_.substep_ms = substep_ms;
    const auto failure = device_failure([&] {
        look(session, now_s);
        work(session, std::clamp(share_of_frame * frame_ms, least_ms, most_ms));
    });
    if (failure) {
        message_ = *failure + " Collisions are not probed.";
        stop();
        asked_ = wanted_;
    }
}

void WindowBudget::look(Session& session, double now_s) {
    const Asked now = to_ask(session);
    if (wanted_ != now) {
        wanted_ = now;
        wanted_since_s_ = now_s;
    }
    settling_ = asked_ != wanted_;
    if (settling_ && now_s - wanted_since_s_ >= (asked_ ? settle_s : 0.0)) {
        start(session);
        asked_ = wanted_;
        settling_ = false;
    }
}

// The balls are copied on the device, and looked at when the copy has arrived.
void WindowBudget::start(Session& session) {
    stop();
    meters_.ask(session);
    patience_ = most_patience;
    Backend& backend = session.simulation().backend();
    backend.start_history(1);
    backend.record_history();
    backend.request_history();
    state_.probe_ms = 0.0;
    state_.choice.reset();  // it answered another question
    phase_ = Phase::reading;
}

// True once it is there.
bool WindowBudget::read_state(Session& session) {
    Simulation& simulation = session.simulation();
    BallState state;
    if (simulation.settings().balls > 0) {
        if (!copy_) {
            copy_ = simulation.backend().poll_history();
        }
        if (!copy_ || (meters_.awaiting() && --patience_ > 0)) {
            return false;
        }
        const std::vector<vec4> numbers = typed<vec4>(*std::exchange(copy_, std::nullopt));
        const auto half = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
        state.positions.assign(numbers.begin(), half);
        state.velocities.assign(half, numbers.end());
        state.restitutions = simulation.restitutions();
    }
    simulation.backend().start_history(0);
    const Settings& settings = simulation.settings();
    const bool moving = simulation.features().has(Feature::moving_walls);
    const measure::ProbeScene scene =
        measure::probe_scene(state, settings, simulation.box(), simulation.variety(), moving);
    question_ = {{settings, scene}, options_.budget, options_.historical, {}, {}};
    if (const auto& record = meters_.answer()) {
        question_.reading = record->reading;
    }
    return true;
}

// One slice of what is under way; false where the device has to answer first.
bool WindowBudget::slice() {
    if (phase_ == Phase::probing) {
        const std::uint32_t before = probe_->substeps_run();
        if (!probe_->advance(slice_substeps)) {
            return probe_->substeps_run() != before;
        }
        state_.probe = probe_->result();
        state_.drift = measure::energy_drift(question_.probe, probe_->result());
        state_.probe_substeps = probe_->substeps_run();
        state_.firm_stiffness = measure::firm_stiffness(question_, probe_->result().softness());
        state_.typical_speed = question_.probe.scene.typical_speed;
        state_.largest_speed = question_.probe.scene.largest_speed;
        state_.speed_is_assumed = question_.probe.scene.speed_is_assumed;
        probe_.reset();
        chooser_.emplace(*twin_, question_);
        phase_ = Phase::choosing;
        return true;
    }
    const std::uint32_t before = chooser_->substeps_run();
    if (!chooser_->advance(slice_substeps)) {
        return chooser_->substeps_run() != before;
    }
    state_.choice = chooser_->choice();
    state_.probe_substeps += chooser_->substeps_run();
    stop();
    return false;
}

void WindowBudget::work(Session& session, double slice_ms) {
    const auto begin = std::chrono::steady_clock::now();
    if (phase_ == Phase::reading && read_state(session)) {
        twin_ = session.twin_backend();
        probe_.emplace(*twin_, question_.probe);
        phase_ = Phase::probing;
    }
    while ((phase_ == Phase::probing || phase_ == Phase::choosing) && slice() && milliseconds_since(begin) < slice_ms) {
    }
    if (phase_ != Phase::idle) {
        state_.probe_ms += milliseconds_since(begin);
    }
}

const ui::BudgetState* WindowBudget::describe(const Session& session, bool open) {
    if (!open) {
        return nullptr;
    }
    state_.options = options_;
    state_.measuring = working();
    if (state_.choice) {
        question_.substep_ms = state_.substep_ms;
        const Settings& settings = session.simulation().settings();
        state_.applied =
            state_.choice->substeps == settings.substeps && state_.choice->integrator == settings.integrator;
        state_.sentence =
            state_.choice->nothing ? state_.choice->sentence : measure::budget_sentence(question_, *state_.choice);
    }
    return &state_;
}

}  // namespace ballpit::app
