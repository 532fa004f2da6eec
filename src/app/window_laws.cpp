#include "app/window_laws.h"

#include <algorithm>

#include "app/measured_run.h"
#include "core/ledger.h"
#include "gl/error.h"
#include "ui/widgets.h"

namespace ballpit::app {

namespace {

constexpr double settle_s = 0.4;  // settings that are still being changed are not measured
// Of a frame, for measuring: a share of what it takes anyway, so that slow frames do not make it last for ever.
constexpr double share_of_frame = 0.25;
constexpr double least_ms = 4.0;
constexpr double most_ms = 50.0;

const gpu::Programs::OnDemand* on_demand(const gpu::Programs& programs, const Program& program) {
    const auto all = programs.on_demand();
    const auto found = std::ranges::find(all, program, &gpu::Programs::OnDemand::program);
    return found == all.end() ? nullptr : &*found;
}

std::string sentence(const gpu::Programs::OnDemand& compiled) {
    return "Compiled " + ui::program_text(compiled.program) + ui::format(" (%.0f ms)", compiled.ms) +
           ": no shipped scene has this set of laws.";
}

// What a hand does to walls and balls is no law of the scene.
bool moved_by_hand(const Program& program) {
    return program.features.has(Feature::pull) || program.features.has(Feature::moving_walls);
}

}  // namespace

WindowLaws::Measured WindowLaws::to_measure(const Session& session) {
    Measured wanted{session.simulation().settings(), session.scene_changes(), &session.simulation().backend()};
    wanted.settings.pull.reset();
    return wanted;
}

void WindowLaws::update(Session& session, bool open, double now_s, double frame_ms) {
    tell_of_programs(session);
    if (!open) {
        meter_.stop();
        measured_.reset();
        wanted_.reset();
        settling_ = false;
        return;
    }
    const auto failure = device_failure([&] {
        measure(session, now_s);
        meter_.update(std::clamp(share_of_frame * frame_ms, least_ms, most_ms));
    });
    if (failure) {
        message_ = *failure + " The laws are not measured.";
        measured_ = wanted_;
        meter_.stop();
    }
}

void WindowLaws::measure(Session& session, double now_s) {
    const Measured now = to_measure(session);
    if (wanted_ != now) {
        wanted_ = now;
        wanted_since_s_ = now_s;
    }
    settling_ = measured_ != wanted_;
    if (settling_ && now_s - wanted_since_s_ >= settle_s) {
        meter_.start(session.simulation(), session.twin_backend());
        measured_ = wanted_;
        settling_ = false;
    }
}

void WindowLaws::build_ahead(Session& session) {
    if (!building_ || session.simulation().backend().name() != "gpu") {
        building_ = false;
        return;
    }
    try {
        building_ = session.programs().build_one();
    } catch (const gl::Error& error) {  // whoever runs that scene will be told again
        building_ = false;
        message_ = error.what();
    }
}

void WindowLaws::tell_of_programs(const Session& session) {
    if (layout_ == session.layout_changes() && !told_.empty()) {
        return;
    }
    layout_ = session.layout_changes();
    for (const Dispatch& dispatch : session.simulation().whole_schedule().dispatches) {
        if (dispatch.program.shader != Shader::collide) {
            continue;  // only there do laws make programs
        }
        const auto* compiled = on_demand(session.programs(), dispatch.program);
        if (told_.insert(dispatch.program).second && compiled != nullptr && !moved_by_hand(dispatch.program)) {
            message_ = sentence(*compiled);
        }
    }
}

const ui::LawsState* WindowLaws::describe(const Session& session, bool open) {
    if (!open) {
        return nullptr;
    }
    const Schedule& schedule = session.simulation().whole_schedule();
    state_ = {};
    state_.costs = meter_.costs();
    state_.measuring = meter_.busy() || settling_;
    state_.ball_count = schedule.ball_count;
    state_.bytes_a_ball = bytes_per_ball(schedule);
    state_.dispatches = schedule.dispatches.size();
    state_.substep_ms = meter_.substep_ms();
    std::set<Program> seen;
    for (const Dispatch& dispatch : schedule.dispatches) {
        if (!seen.insert(dispatch.program).second) {
            continue;
        }
        state_.programs.push_back(ui::program_text(dispatch.program));
        if (const auto* compiled = on_demand(session.programs(), dispatch.program)) {
            state_.on_demand.push_back(sentence(*compiled));
        }
    }
    return &state_;
}

}  // namespace ballpit::app
