// Stepping as the window's loop meets it: keys and commands in, wishes for copies, and what strip, microscope and
// badges show.
#pragma once

#include "app/clock.h"
#include "app/window_inspector.h"
#include "app/window_live_check.h"
#include "app/window_session.h"
#include "app/window_stage_numbers.h"
#include "ui/commands.h"

namespace ballpit::app {

class Stepping {
public:
    /// Session and clock must outlive it. Whoever moves through time wants it to stand still: the clock pauses.
    Stepping(Session& session, Clock& clock) : session_(session), clock_(clock), check_(session) {}

    /// True where the action is one of stepping's.
    bool act(ui::Action action, ui::ViewOptions& view);
    void act(const ui::ChooseUnit& command, ui::ViewOptions& view);
    void act(const ui::StepForward& command);
    void act(const ui::StepBack& command);
    void act(const ui::GoTo& command);
    void act(const ui::SetCheckpointBudget& command) { session_.stepper().set_budget(command.bytes); }
    void act(const ui::SetLiveCheck& command) { check_.set_mode(command.mode); }
    void act(const ui::ShowDifferences& command) { check_.show(command.stage); }

    /// Once a frame, before Inspector::update().
    void want(Inspector& inspector, const ui::ViewOptions& view);
    /// After it.
    void update(const Inspector& inspector, const ui::ViewOptions& view);

    const ui::SteppingState& state() const { return state_; }

private:
    bool move(ui::Action action);
    bool choose_unit(ui::Action action, ui::ViewOptions& view);
    bool open(ui::Action action, ui::ViewOptions& view);
    bool tells_numbers(const ui::ViewOptions& view) const { return view.stepper && !clock_.running(); }
    void toggle_check(ui::ViewOptions& view);
    void show_next_differences();

    Session& session_;
    Clock& clock_;
    LiveCheck check_;
    StageNumbersReader numbers_;
    ui::SteppingState state_;
};

}  // namespace ballpit::app
