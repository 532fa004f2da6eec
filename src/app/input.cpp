#include "app/input.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

namespace ballpit::app {

namespace {

using ui::Action;

constexpr int click_slack = 4;  // points that a hand may slip between press and release

struct KeyActions {
    SDL_Keycode key;
    Action plain;
    Action with_shift;
};

constexpr std::array<KeyActions, 50> keys = {{
    {SDLK_SPACE, Action::toggle_run, Action::toggle_run},
    {SDLK_p, Action::toggle_run, Action::toggle_run},
    {SDLK_o, Action::one_step, Action::one_step},
    {SDLK_RETURN, Action::one_step, Action::one_step},
    {SDLK_KP_ENTER, Action::one_step, Action::one_step},
    {SDLK_r, Action::restart, Action::new_seed},
    {SDLK_LEFTBRACKET, Action::previous_scene, Action::previous_scene},
    {SDLK_RIGHTBRACKET, Action::next_scene, Action::next_scene},
    {SDLK_b, Action::shoot_ball, Action::shoot_ball},
    {SDLK_n, Action::add_cluster, Action::add_cluster},
    {SDLK_h, Action::toggle_hand, Action::toggle_hand},
    {SDLK_z, Action::toggle_shake, Action::toggle_shake},
    {SDLK_g, Action::toggle_occupancy, Action::toggle_occupancy},
    {SDLK_RIGHT, Action::forward, Action::forward_coarser},
    {SDLK_PAGEDOWN, Action::forward, Action::forward_coarser},
    {SDLK_LEFT, Action::back, Action::back_coarser},
    {SDLK_PAGEUP, Action::back, Action::back_coarser},
    {SDLK_1, Action::unit_pass, Action::unit_pass},
    {SDLK_2, Action::unit_stage, Action::unit_stage},
    {SDLK_3, Action::unit_substep, Action::unit_substep},
    {SDLK_4, Action::unit_step, Action::unit_step},
    {SDLK_F2, Action::toggle_stepper, Action::toggle_stepper},
    {SDLK_m, Action::toggle_microscope, Action::microscope_size},
    {SDLK_k, Action::toggle_live_check, Action::toggle_live_check},
    {SDLK_j, Action::show_differences, Action::show_differences},
    {SDLK_t, Action::toggle_follow, Action::toggle_follow},
    {SDLK_c, Action::toggle_cells, Action::toggle_cells},
    {SDLK_u, Action::toggle_buffers, Action::next_slot},
    {SDLK_x, Action::toggle_split, Action::toggle_split},
    {SDLK_i, Action::toggle_contacts, Action::toggle_contacts},
    {SDLK_v, Action::toggle_arrows, Action::next_colour},
    {SDLK_l, Action::toggle_slice, Action::slice_axis},
    {SDLK_UP, Action::layer_up, Action::layer_up},
    {SDLK_DOWN, Action::layer_down, Action::layer_down},
    {SDLK_PERIOD, Action::next_ball, Action::next_ball},
    {SDLK_COMMA, Action::previous_ball, Action::previous_ball},
    {SDLK_DELETE, Action::clear_selection, Action::clear_selection},
    {SDLK_BACKSPACE, Action::clear_selection, Action::clear_selection},
    {SDLK_F3, Action::toggle_timings, Action::toggle_timings},
    {SDLK_f, Action::share, Action::share},
    {SDLK_F4, Action::toggle_laws, Action::toggle_laws},
    {SDLK_F6, Action::toggle_meters, Action::toggle_meters},
    {SDLK_F7, Action::toggle_budget, Action::toggle_budget},
    {SDLK_F8, Action::toggle_explorer, Action::toggle_explorer},
    {SDLK_F9, Action::toggle_costs, Action::toggle_costs},
    {SDLK_TAB, Action::toggle_panels, Action::toggle_panels},
    {SDLK_F11, Action::full_screen, Action::full_screen},
    {SDLK_HOME, Action::camera_home, Action::camera_home},
    {SDLK_F1, Action::toggle_help, Action::toggle_help},
    {SDLK_ESCAPE, Action::close, Action::close},
}};

struct PlaceAction {
    SDL_Scancode place;
    Action action;
};

// Keys by their place: many layouts have no brackets, some have digits only with Shift.
constexpr std::array<PlaceAction, 6> places = {{
    {SDL_SCANCODE_LEFTBRACKET, Action::previous_scene},
    {SDL_SCANCODE_RIGHTBRACKET, Action::next_scene},
    {SDL_SCANCODE_1, Action::unit_pass},
    {SDL_SCANCODE_2, Action::unit_stage},
    {SDL_SCANCODE_3, Action::unit_substep},
    {SDL_SCANCODE_4, Action::unit_step},
}};

std::optional<Action> plain_action(const SDL_Keysym& key) {
    const auto known = std::ranges::find(keys, key.sym, &KeyActions::key);
    if (known != keys.end()) {
        return (key.mod & KMOD_SHIFT) != 0 ? known->with_shift : known->plain;
    }
    const auto place = std::ranges::find(places, key.scancode, &PlaceAction::place);
    return place != places.end() ? std::optional(place->action) : std::nullopt;
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
