#include "app/window_stepping.h"

#include "view/palette.h"

namespace ballpit::app {

namespace {

StepUnit coarser(StepUnit unit) {
    return unit == StepUnit::step ? unit : static_cast<StepUnit>(static_cast<int>(unit) + 1);
}

// 16, 64, all (0).
std::uint32_t next_size(std::uint32_t slots) { return slots == 16 ? 64 : slots == 64 ? 0 : 16; }

}  // namespace

bool Stepping::act(ui::Action action, ui::ViewOptions& view) {
    return move(action) || choose_unit(action, view) || open(action, view);
}

bool Stepping::move(ui::Action action) {
    switch (action) {
        case ui::Action::forward:
            act(ui::StepForward{state_.unit});
            return true;
        case ui::Action::back:
            act(ui::StepBack{state_.unit});
            return true;
        case ui::Action::forward_coarser:
            act(ui::StepForward{coarser(state_.unit)});
            return true;
        case ui::Action::back_coarser:
            act(ui::StepBack{coarser(state_.unit)});
            return true;
        case ui::Action::step_start:
            clock_.pause();
            session_.to_step_start();
            return true;
        case ui::Action::step_end:
            clock_.pause();
            session_.to_step_end();
            return true;
        default:
            return false;
    }
}

bool Stepping::choose_unit(ui::Action action, ui::ViewOptions& view) {
    switch (action) {
        case ui::Action::unit_pass:
            act(ui::ChooseUnit{StepUnit::pass}, view);
            return true;
        case ui::Action::unit_stage:
            act(ui::ChooseUnit{StepUnit::stage}, view);
            return true;
        case ui::Action::unit_substep:
            act(ui::ChooseUnit{StepUnit::substep}, view);
            return true;
        case ui::Action::unit_step:
            act(ui::ChooseUnit{StepUnit::step}, view);
            return true;
        default:
            return false;
    }
}

bool Stepping::open(ui::Action action, ui::ViewOptions& view) {
    switch (action) {
        case ui::Action::toggle_stepper:
            view.stepper = !view.stepper;
            return true;
        case ui::Action::toggle_microscope:
            view.microscope = !view.microscope;
            return true;
        case ui::Action::microscope_size:
            view.microscope = true;
            view.microscope_options.slots = next_size(view.microscope_options.slots);
            return true;
        case ui::Action::toggle_live_check:
            toggle_check(view);
            return true;
        case ui::Action::show_differences:
            show_next_differences();
            return true;
        default:
            return false;
    }
}

// Parts of a step are for looking at: the strip shows where one is.
void Stepping::act(const ui::ChooseUnit& command, ui::ViewOptions& view) {
    state_.unit = command.unit;
    view.stepper = view.stepper || command.unit != StepUnit::step;
}

void Stepping::act(const ui::StepForward& command) {
    clock_.pause();
    session_.forward(command.unit);
}

void Stepping::act(const ui::StepBack& command) {
    clock_.pause();
    session_.back(command.unit);
}

void Stepping::act(const ui::GoTo& command) {
    clock_.pause();
    session_.go_to(command.place);
}

// What it finds shows on the strip.
void Stepping::toggle_check(ui::ViewOptions& view) {
    const bool off = check_.mode() == ui::LiveCheckMode::off;
    check_.set_mode(off ? ui::LiveCheckMode::mirror : ui::LiveCheckMode::off);
    view.stepper = view.stepper || off;
}

// Stage by stage, then closed.
void Stepping::show_next_differences() {
    const std::size_t next = check_.shown() ? static_cast<std::size_t>(*check_.shown()) + 1 : 0;
    check_.show(next < stage_count ? std::optional(static_cast<Stage>(next)) : std::nullopt);
}

void Stepping::want(Inspector& inspector, const ui::ViewOptions& view) {
    session_.update();
    session_.describe(state_);
    if (view.microscope) {
        inspector.want(Slot::keys);
        inspector.want_keys_before();
    }
    if (tells_numbers(view)) {
        StageNumbersReader::ask(inspector, state_);
    }
}

void Stepping::update(const Inspector& inspector, const ui::ViewOptions& view) {
    if (tells_numbers(view)) {
        state_.numbers = numbers_.read(inspector, state_, session_.simulation().box(), session_.revision());
    }
    check_.describe(state_.check);
    for (std::size_t i = 0; i < stage_count; ++i) {
        state_.stage_colours[i] = view::categorical(static_cast<std::uint32_t>(i));
    }
}

}  // namespace ballpit::app
