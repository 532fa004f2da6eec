// Session: forth and back in time, and where that leads.
#include <algorithm>

#include "app/window_session.h"

namespace ballpit::app {

// Settings that were changed on the way change back with the time.
void Session::move(const std::function<void()>& motion) {
    const Settings before = simulation_->settings();
    motion();
    if (simulation_->settings() != before) {
        wanted_ = simulation_->settings();
        ++layout_changes_;
    }
    const Position now = stepper_->position();
    furthest_step_ = std::max(furthest_step_, now.moment.step);
    cells_ready_ = now != Position{stepper_->timeline().start(), 0};
    ++revision_;
}

void Session::forward(StepUnit unit) {
    const Moment before = stepper_->position().moment;
    move([&] { stepper_->forward(unit); });
    look_from(stepper_->position().moment != before);
}

void Session::back(StepUnit unit) {
    if (behind_ && unit == StepUnit::step) {
        to_step_start();  // of the step that is shown
        return;
    }
    move([&] { stepper_->back(unit); });
    look_from(false);
}

void Session::to_step_start() {
    const std::uint64_t step = place().substep.step;
    go_to({std::max(Moment{step, 0}, stepper_->timeline().start()), 0});
}

void Session::to_step_end() {
    if (!behind_ || simulation_->substep_in_step() > 0) {
        forward(StepUnit::step);
    }
}

void Session::go_to(const ui::Place& place) {
    if (place == this->place()) {
        return;
    }
    move([&] { stepper_->go_to({place.substep, place.ran}); });
    look_from(stepper_->position().moment > place.substep);  // the last dispatch leads into the next substep
}

void Session::run_again(const std::function<void()>& before) {
    const ui::Place shown = place();
    move([&] {
        stepper_->go_to({shown.substep, 0});
        before();
        stepper_->go_to({shown.substep, shown.ran});
    });
    look_from(stepper_->position().moment > shown.substep);
}

void Session::look_from(bool behind) {
    behind_.reset();
    const Position now = stepper_->position();
    if (!behind || now.dispatch > 0 || !stepper_->timeline().changes_at(now.moment).empty()) {
        return;  // after a change of settings the substep before had other dispatches
    }
    if (now.moment.substep > 0) {
        behind_ = Moment{now.moment.step, now.moment.substep - 1};
    } else if (const std::uint64_t step = now.moment.step; step > 0) {
        behind_ = Moment{step - 1, stepper_->timeline().substeps_of(step - 1) - 1};
    }
}

ui::Place Session::place() const {
    const Position now = stepper_->position();
    if (behind_) {
        return {*behind_, static_cast<std::uint32_t>(stepper_->schedule_behind().dispatches.size())};
    }
    return {now.moment, now.dispatch};
}

void Session::describe(ui::SteppingState& state) const {
    const Timeline& timeline = stepper_->timeline();
    const Position now = stepper_->position();
    state.place = place();
    state.substeps = state.place.substep.step < now.moment.step
                         ? timeline.substeps_of(state.place.substep.step)
                         : std::max(simulation_->settings().substeps, state.place.substep.substep + 1);
    state.schedule = behind_ ? &stepper_->schedule_behind() : &stepper_->schedule();
    state.grid_reuse = simulation_->settings().grid_reuse;
    state.building = static_cast<std::uint32_t>(stepper_->schedule_of(true).dispatches.size());
    state.using_again = static_cast<std::uint32_t>(stepper_->schedule_of(false).dispatches.size());
    state.first_step = timeline.start().step;
    state.furthest_step = furthest_step_;
    state.hash_step = now.moment.step;
    state.hash = timeline.hash(now.moment.step);
    state.divergence = stepper_->divergence();
    state.checkpoint_bytes = timeline.used_bytes();
    state.checkpoint_budget = timeline.budget();
    state.checkpoint_count = timeline.checkpoint_count();
}

}  // namespace ballpit::app
