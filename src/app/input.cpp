#include "app/input.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace ballpit::app {

namespace {

using ui::Action;

constexpr int click_slack = 4;  // points that a hand may slip between press and release

std::optional<Action> plain_action(const SDL_Keysym& key) {
    switch (key.sym) {
        case SDLK_SPACE:
        case SDLK_p:
            return Action::toggle_run;
        case SDLK_o:
        case SDLK_RETURN:
        case SDLK_KP_ENTER:
            return Action::one_step;
        case SDLK_r:
            return (key.mod & KMOD_SHIFT) != 0 ? Action::new_seed : Action::restart;
        case SDLK_LEFTBRACKET:
            return Action::previous_scene;
        case SDLK_RIGHTBRACKET:
            return Action::next_scene;
        case SDLK_b:
            return Action::shoot_ball;
        case SDLK_n:
            return Action::add_cluster;
        case SDLK_h:
            return Action::toggle_hand;
        case SDLK_z:
            return Action::toggle_shake;
        case SDLK_g:
            return Action::toggle_occupancy;
        case SDLK_RIGHT:
        case SDLK_PAGEDOWN:
            return (key.mod & KMOD_SHIFT) != 0 ? Action::forward_coarser : Action::forward;
        case SDLK_LEFT:
        case SDLK_PAGEUP:
            return (key.mod & KMOD_SHIFT) != 0 ? Action::back_coarser : Action::back;
        case SDLK_1:
            return Action::unit_pass;
        case SDLK_2:
            return Action::unit_stage;
        case SDLK_3:
            return Action::unit_substep;
        case SDLK_4:
            return Action::unit_step;
        case SDLK_F2:
            return Action::toggle_stepper;
        case SDLK_m:
            return (key.mod & KMOD_SHIFT) != 0 ? Action::microscope_size : Action::toggle_microscope;
        case SDLK_k:
            return Action::toggle_live_check;
        case SDLK_j:
            return Action::show_differences;
        case SDLK_t:
            return Action::toggle_follow;
        case SDLK_c:
            return Action::toggle_cells;
        case SDLK_u:
            return (key.mod & KMOD_SHIFT) != 0 ? Action::next_slot : Action::toggle_buffers;
        case SDLK_x:
            return Action::toggle_split;
        case SDLK_i:
            return Action::toggle_contacts;
        case SDLK_v:
            return (key.mod & KMOD_SHIFT) != 0 ? Action::next_colour : Action::toggle_arrows;
        case SDLK_l:
            return (key.mod & KMOD_SHIFT) != 0 ? Action::slice_axis : Action::toggle_slice;
        case SDLK_UP:
            return Action::layer_up;
        case SDLK_DOWN:
            return Action::layer_down;
        case SDLK_PERIOD:
            return Action::next_ball;
        case SDLK_COMMA:
            return Action::previous_ball;
        case SDLK_DELETE:
        case SDLK_BACKSPACE:
            return Action::clear_selection;
        case SDLK_F3:
            return Action::toggle_timings;
        case SDLK_f:
            return Action::share;
        case SDLK_F4:
            return Action::toggle_laws;
        case SDLK_TAB:
            return Action::toggle_panels;
        case SDLK_F11:
            return Action::full_screen;
        case SDLK_HOME:
            return Action::camera_home;
        case SDLK_F1:
            return Action::toggle_help;
        case SDLK_ESCAPE:
            return Action::close;
        default:
            break;
    }
    switch (key.scancode) {
        case SDL_SCANCODE_LEFTBRACKET:
            return Action::previous_scene;
        case SDL_SCANCODE_RIGHTBRACKET:
            return Action::next_scene;
        case SDL_SCANCODE_1:  // some layouts have digits only with Shift
            return Action::unit_pass;
        case SDL_SCANCODE_2:
            return Action::unit_stage;
        case SDL_SCANCODE_3:
            return Action::unit_substep;
        case SDL_SCANCODE_4:
            return Action::unit_step;
        default:
            return std::nullopt;
    }
}

std::optional<Action> control_action(const SDL_Keysym& key) {
    switch (key.sym) {
        case SDLK_q:
            return Action::quit;
        case SDLK_s:
            return Action::save_scene;
        case SDLK_v:
            return Action::paste_code;
        case SDLK_HOME:
            return Action::step_start;
        case SDLK_END:
            return Action::step_end;
        default:
            return std::nullopt;
    }
}

bool repeats(std::optional<Action> action) {
    return action == Action::one_step || action == Action::forward || action == Action::back ||
           action == Action::forward_coarser || action == Action::back_coarser || action == Action::next_ball ||
           action == Action::previous_ball || action == Action::layer_up || action == Action::layer_down;
}

// What no text field has a use for; a share code is pasted wherever the cursor is.
bool works_while_typing(Action action) {
    return action == Action::quit || action == Action::save_scene || action == Action::paste_code;
}

bool held(SDL_Keycode key) {
    int count = 0;
    const Uint8* states = SDL_GetKeyboardState(&count);
    const SDL_Scancode code = SDL_GetScancodeFromKey(key);
    return code < count && states[code] != 0;
}

// Along the camera's right and forward and the world's up; opposite keys cancel.
vec3 held_direction() {
    if ((SDL_GetModState() & (KMOD_CTRL | KMOD_ALT | KMOD_GUI)) != 0) {
        return vec3(0.0f);
    }
    const auto axis = [](SDL_Keycode more, SDL_Keycode less) {
        return static_cast<float>(held(more)) - static_cast<float>(held(less));
    };
    return {axis(SDLK_d, SDLK_a), axis(SDLK_w, SDLK_s), axis(SDLK_e, SDLK_q)};
}

}  // namespace

std::optional<Action> action_of(const SDL_Keysym& key, bool repeated) {
    if ((key.mod & (KMOD_ALT | KMOD_GUI)) != 0) {
        return std::nullopt;  // the window manager's, not ours
    }
    const std::optional<Action> action = (key.mod & KMOD_CTRL) != 0 ? control_action(key) : plain_action(key);
    return repeated && !repeats(action) ? std::nullopt : action;
}

void Input::handle(const SDL_Event& event, bool typing, int height) {
    switch (event.type) {
        case SDL_KEYDOWN:
            if (const auto action = action_of(event.key.keysym, event.key.repeat != 0);
                action && (!typing || works_while_typing(*action))) {
                commands_.emplace_back(*action);
            }
            break;
        case SDL_MOUSEBUTTONDOWN:
        case SDL_MOUSEBUTTONUP:
            handle_button(event.button);
            break;
        case SDL_MOUSEMOTION:
            handle_motion(event.motion, height);
            break;
        case SDL_MOUSEWHEEL:
            notches_ += event.wheel.preciseY;
            break;
        case SDL_WINDOWEVENT:
            dragging_ = event.window.event == SDL_WINDOWEVENT_FOCUS_LOST ? Uint8{0} : dragging_;
            break;
        default:
            break;
    }
}

void Input::handle_button(const SDL_MouseButtonEvent& button) {
    const view::vec2 place(static_cast<float>(button.x), static_cast<float>(button.y));
    pointer_ = place;
    const bool ours = button.button == SDL_BUTTON_LEFT || button.button == SDL_BUTTON_RIGHT;
    if (button.type == SDL_MOUSEBUTTONDOWN && ours && dragging_ == 0) {
        dragging_ = button.button;
        dragged_ = 0;
        undecided_ = true;
        looking_ = !(hand_ && button.button == SDL_BUTTON_LEFT);
        press_ = looking_ ? std::nullopt : std::optional(place);
    } else if (button.type == SDL_MOUSEBUTTONUP && button.button == dragging_) {
        if (dragging_ == SDL_BUTTON_LEFT && dragged_ <= click_slack && looking_) {
            click_ = place;
        }
        dragging_ = 0;
    }
}

// A drag belongs to where it began: a slider pulled beyond its panel never turns the camera, nor the other way round.
// Where it began is known only now: in a slow frame the pointer comes, presses and moves on before any panel sees it.
void Input::settle_claims(bool over_panel) {
    if (over_panel && undecided_) {
        dragging_ = 0;
        look_ = pan_ = view::vec2(0.0f);
        click_.reset();
        press_.reset();
    }
    undecided_ = false;
    notches_ = over_panel ? 0.0f : notches_;
}

void Input::handle_motion(const SDL_MouseMotionEvent& motion, int height) {
    pointer_ = view::vec2(static_cast<float>(motion.x), static_cast<float>(motion.y));
    dragged_ += dragging_ != 0 ? std::abs(motion.xrel) + std::abs(motion.yrel) : 0;
    const view::vec2 drag =
        view::vec2(static_cast<float>(motion.xrel), static_cast<float>(motion.yrel)) / static_cast<float>(height);
    if (dragging_ == SDL_BUTTON_LEFT && looking_) {
        look_ += drag;
    } else if (dragging_ == SDL_BUTTON_RIGHT) {
        pan_ += drag;
    }
}

std::optional<view::vec2> Input::take_click() { return std::exchange(click_, std::nullopt); }

ui::Commands Input::take_commands() { return std::exchange(commands_, {}); }

view::Camera Input::moved(view::Camera camera, const vec3& half_extent, float seconds, bool typing, bool over_panel) {
    settle_claims(over_panel);
    if (!typing) {
        const float largest = std::max({half_extent.x, half_extent.y, half_extent.z});
        const bool fast = (SDL_GetModState() & KMOD_SHIFT) != 0;
        const float metres = seconds * largest * (fast ? 4.0f : 1.0f);
        camera = view::move(camera, metres * held_direction());
    }
    camera = view::look(camera, std::exchange(look_, view::vec2(0.0f)));
    camera = view::pan(camera, std::exchange(pan_, view::vec2(0.0f)), half_extent);
    return view::zoom(camera, std::exchange(notches_, 0.0f), half_extent);
}

bool Input::active(bool typing) const { return dragging_ != 0 || (!typing && held_direction() != vec3(0.0f)); }

}  // namespace ballpit::app
