// What the window does when a key, a panel or the mouse asks for it.
#include <SDL.h>

#include <algorithm>
#include <array>
#include <variant>

#include "app/window_main.h"

namespace ballpit::app {

namespace {

// What may be done while a code's run is replayed: nothing that touches the run.
bool leaves_run_alone(const ui::Command& command) {
    if (const auto* action = std::get_if<ui::Action>(&command)) {
        constexpr std::array harmless = {ui::Action::close,       ui::Action::quit,        ui::Action::toggle_panels,
                                         ui::Action::full_screen, ui::Action::camera_home, ui::Action::toggle_help};
        return std::ranges::find(harmless, *action) != harmless.end();
    }
    return std::holds_alternative<ui::ChangeView>(command) || std::holds_alternative<ui::ChangeLight>(command) ||
           std::holds_alternative<ui::ChangeTextSize>(command) || std::holds_alternative<ui::DismissMessage>(command);
}

}  // namespace

void Window::carry_out(const ui::Commands& commands) {
    for (const ui::Command& command : commands) {
        if (!sharing_.replaying() || leaves_run_alone(command)) {
            std::visit([this](const auto& c) { act(c); }, command);
        }
    }
}

void Window::act(ui::Action action) {
    const auto pointer = gui_.over_panel() ? std::nullopt : std::optional(input_.pointer());
    if (views_.act(action, inspection_, session_) || stepping_.act(action, view_) || sharing_.act(action) ||
        play_.act(action, session_, eye(), pointer)) {
        return;
    }
    switch (action) {
        case ui::Action::toggle_run:
            return clock_.toggle_run();
        case ui::Action::one_step:
            return clock_.step_once();
        case ui::Action::restart:
            return session_.restart(false);
        case ui::Action::new_seed:
            return session_.restart(true);
        case ui::Action::previous_scene:
            return session_.next_scene(-1);
        case ui::Action::next_scene:
            return session_.next_scene(1);
        case ui::Action::toggle_occupancy:
            view_.occupancy = !view_.occupancy;
            return;
        case ui::Action::toggle_timings:
            view_.timings = !view_.timings;
            return;
        case ui::Action::toggle_laws:
            view_.laws = !view_.laws;
            return;
        case ui::Action::toggle_meters:
            view_.meters = !view_.meters;
            return;
        case ui::Action::toggle_budget:
            view_.budget = !view_.budget;
            return;
        case ui::Action::toggle_explorer:
            view_.explorer = !view_.explorer;
            return;
        case ui::Action::toggle_costs:
            view_.costs = !view_.costs;
            return;
        case ui::Action::next_colour:
            view_.colour = static_cast<ui::BallColour>((static_cast<std::size_t>(view_.colour) + 1) % ui::ball_colours);
            return;
        case ui::Action::toggle_panels:
            view_.panels = !view_.panels;
            return;
        case ui::Action::full_screen:
            return toggle_full_screen();
        case ui::Action::camera_home:
            return camera_.go_home();
        case ui::Action::toggle_help:
            view_.help = !view_.help;
            return;
        case ui::Action::close:
            return close_topmost();
        case ui::Action::quit:
            quit_ = true;
            return;
        default:
            return;  // theirs
    }
}

void Window::act(const ui::ChangeSettings& command) {
    const Simulation& simulation = session_.simulation();
    const bool brute_force = command.settings.neighbours == NeighbourSearch::brute_force;
    const auto refusal = brute_force_refusal(command.settings.balls, simulation.features().has(Feature::contact),
                                             simulation.backend().name());
    if (brute_force && refusal) {
        message_ = *refusal;
    } else {
        session_.want(command.settings);
    }
}

void Window::act(const ui::SelectBall& command) {
    inspection_.ball = command.ball;
    flight_wanted_ = command.fly && command.ball;
}

// One thing a press, what lies on top first; never the program.
void Window::close_topmost() {
    if (gui_.popup_open()) {
        close_popups_ = true;
    } else if (view_.help) {
        view_.help = false;
    } else if (sharing_.close()) {
        return;
    } else if (!message_.empty()) {
        message_.clear();
    } else if (full_screen_) {
        toggle_full_screen();
    }
}

void Window::toggle_full_screen() {
    if (!full_screen_) {
        place_ = place_of(context_.window());
    }
    full_screen_ = !full_screen_;
    SDL_SetWindowFullscreen(context_.window(), full_screen_ ? SDL_WINDOW_FULLSCREEN_DESKTOP : 0);
}

}  // namespace ballpit::app
