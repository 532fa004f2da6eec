// Keys: each row of the help page has the keys that it prints, and modifiers are not ours to take.
#include <set>

#include "app/input.h"
#include "support/catch.h"

using namespace ballpit;
using app::action_of;
using ui::Action;

namespace {

SDL_Keysym key(SDL_Keycode code, int mod = KMOD_NONE, SDL_Scancode scancode = SDL_SCANCODE_UNKNOWN) {
    SDL_Keysym sym{};
    sym.sym = code;
    sym.mod = static_cast<Uint16>(mod);
    sym.scancode = scancode;
    return sym;
}

SDL_Event press(SDL_Keycode code, int mod = KMOD_NONE) {
    SDL_Event event{};
    event.type = SDL_KEYDOWN;
    event.key.keysym = key(code, mod);
    return event;
}

SDL_Event button(Uint32 type, Uint8 which) {
    SDL_Event event{};
    event.type = type;
    event.button.type = type;
    event.button.button = which;
    return event;
}

SDL_Event motion(int x, int y) {
    SDL_Event event{};
    event.type = SDL_MOUSEMOTION;
    event.motion.xrel = x;
    event.motion.yrel = y;
    return event;
}

constexpr int height = 720;

}  // namespace

TEST_CASE("keys do what the help page says", "[ui]") {
    CHECK(action_of(key(SDLK_SPACE), false) == Action::toggle_run);
    CHECK(action_of(key(SDLK_p), false) == Action::toggle_run);
    CHECK(action_of(key(SDLK_o), false) == Action::one_step);
    CHECK(action_of(key(SDLK_RETURN), false) == Action::one_step);
    CHECK(action_of(key(SDLK_KP_ENTER), false) == Action::one_step);
    CHECK(action_of(key(SDLK_r), false) == Action::restart);
    CHECK(action_of(key(SDLK_r, KMOD_LSHIFT), false) == Action::new_seed);
    CHECK(action_of(key(SDLK_LEFTBRACKET), false) == Action::previous_scene);
    CHECK(action_of(key(SDLK_RIGHTBRACKET), false) == Action::next_scene);
    CHECK(action_of(key(SDLK_g), false) == Action::toggle_occupancy);
    CHECK(action_of(key(SDLK_F3), false) == Action::toggle_timings);
    CHECK(action_of(key(SDLK_F4), false) == Action::toggle_laws);
    CHECK(action_of(key(SDLK_F6), false) == Action::toggle_meters);
    CHECK(action_of(key(SDLK_b), false) == Action::shoot_ball);
    CHECK(action_of(key(SDLK_n), false) == Action::add_cluster);
    CHECK(action_of(key(SDLK_h), false) == Action::toggle_hand);
    CHECK(action_of(key(SDLK_z), false) == Action::toggle_shake);
    CHECK_FALSE(action_of(key(SDLK_b), true));
    CHECK(action_of(key(SDLK_TAB), false) == Action::toggle_panels);
    CHECK(action_of(key(SDLK_F11), false) == Action::full_screen);
    CHECK(action_of(key(SDLK_HOME), false) == Action::camera_home);
    CHECK(action_of(key(SDLK_F1), false) == Action::toggle_help);
    CHECK(action_of(key(SDLK_ESCAPE), false) == Action::close);
    CHECK(action_of(key(SDLK_q, KMOD_LCTRL), false) == Action::quit);
    CHECK(action_of(key(SDLK_f), false) == Action::share);
    CHECK(action_of(key(SDLK_s, KMOD_LCTRL), false) == Action::save_scene);
    CHECK(action_of(key(SDLK_v, KMOD_LCTRL), false) == Action::paste_code);
    CHECK_FALSE(action_of(key(SDLK_y), false));
}

TEST_CASE("arrows and a clicker's keys step forth and back", "[ui]") {
    for (const auto& [forth, back] : {std::pair(SDLK_RIGHT, SDLK_LEFT), std::pair(SDLK_PAGEDOWN, SDLK_PAGEUP)}) {
        CHECK(action_of(key(forth), false) == Action::forward);
        CHECK(action_of(key(forth, KMOD_RSHIFT), false) == Action::forward_coarser);
        CHECK(action_of(key(back), false) == Action::back);
        CHECK(action_of(key(back, KMOD_LSHIFT), false) == Action::back_coarser);
    }
    CHECK(action_of(key(SDLK_HOME, KMOD_LCTRL), false) == Action::step_start);
    CHECK(action_of(key(SDLK_END, KMOD_RCTRL), false) == Action::step_end);
    CHECK(action_of(key(SDLK_1), false) == Action::unit_pass);
    CHECK(action_of(key(SDLK_2), false) == Action::unit_stage);
    CHECK(action_of(key(SDLK_3), false) == Action::unit_substep);
    CHECK(action_of(key(SDLK_4), false) == Action::unit_step);
    CHECK(action_of(key(SDLK_AMPERSAND, KMOD_NONE, SDL_SCANCODE_1), false) == Action::unit_pass);  // a French keyboard
    CHECK(action_of(key(SDLK_F2), false) == Action::toggle_stepper);
    CHECK(action_of(key(SDLK_m), false) == Action::toggle_microscope);
    CHECK(action_of(key(SDLK_m, KMOD_LSHIFT), false) == Action::microscope_size);
    CHECK(action_of(key(SDLK_k), false) == Action::toggle_live_check);
    CHECK(action_of(key(SDLK_j), false) == Action::show_differences);
}

TEST_CASE("camera keys are no actions", "[ui]") {
    for (const SDL_Keycode code : {SDLK_w, SDLK_a, SDLK_s, SDLK_d, SDLK_e, SDLK_q}) {
        CHECK_FALSE(action_of(key(code), false));
    }
}

TEST_CASE("the brackets' places count on keyboards without brackets", "[ui]") {
    CHECK(action_of(key(0xFC, KMOD_NONE, SDL_SCANCODE_LEFTBRACKET), false) == Action::previous_scene);
    CHECK(action_of(key(SDLK_PLUS, KMOD_NONE, SDL_SCANCODE_RIGHTBRACKET), false) == Action::next_scene);
}

TEST_CASE("Ctrl, Alt and the system key belong to others, but for Ctrl+Q", "[ui]") {
    for (const int mod : {int(KMOD_LCTRL), int(KMOD_LALT), int(KMOD_LGUI)}) {
        CHECK_FALSE(action_of(key(SDLK_r, mod), false));
        CHECK_FALSE(action_of(key(SDLK_SPACE, mod), false));
        CHECK_FALSE(action_of(key(SDLK_TAB, mod), false));
    }
}

TEST_CASE("a held key steps on and on, and toggles nothing twice", "[ui]") {
    CHECK(action_of(key(SDLK_RETURN), true) == Action::one_step);
    CHECK(action_of(key(SDLK_RIGHT), true) == Action::forward);
    CHECK(action_of(key(SDLK_LEFT), true) == Action::back);
    CHECK_FALSE(action_of(key(SDLK_HOME, KMOD_LCTRL), true));
    CHECK_FALSE(action_of(key(SDLK_SPACE), true));
    CHECK_FALSE(action_of(key(SDLK_RIGHTBRACKET), true));
    CHECK_FALSE(action_of(key(SDLK_q, KMOD_LCTRL), true));
}

TEST_CASE("every action has one row on the help page, and a key", "[ui]") {
    std::set<Action> rows;
    for (const ui::KeyRow& row : ui::key_table()) {
        CHECK(rows.insert(row.action).second);
        CHECK_FALSE(row.keys.empty());
        CHECK_FALSE(row.meaning.empty());
        CHECK(ui::key_hint(row.action) == row.hint);
        CHECK(row.keys.find(row.hint) != std::string_view::npos);
    }
    CHECK(rows.size() == ui::action_count);
}

TEST_CASE("keys open the views into a substep and move in them", "[ui]") {
    CHECK(action_of(key(SDLK_t), false) == Action::toggle_follow);
    CHECK(action_of(key(SDLK_c), false) == Action::toggle_cells);
    CHECK(action_of(key(SDLK_u), false) == Action::toggle_buffers);
    CHECK(action_of(key(SDLK_u, KMOD_LSHIFT), false) == Action::next_slot);
    CHECK(action_of(key(SDLK_x), false) == Action::toggle_split);
    CHECK(action_of(key(SDLK_i), false) == Action::toggle_contacts);
    CHECK(action_of(key(SDLK_v), false) == Action::toggle_arrows);
    CHECK(action_of(key(SDLK_v, KMOD_RSHIFT), false) == Action::next_colour);
    CHECK(action_of(key(SDLK_l), false) == Action::toggle_slice);
    CHECK(action_of(key(SDLK_l, KMOD_LSHIFT), false) == Action::slice_axis);
    CHECK(action_of(key(SDLK_UP), true) == Action::layer_up);  // held, it goes on
    CHECK(action_of(key(SDLK_DOWN), true) == Action::layer_down);
    CHECK(action_of(key(SDLK_PERIOD), true) == Action::next_ball);
    CHECK(action_of(key(SDLK_COMMA), true) == Action::previous_ball);
    CHECK(action_of(key(SDLK_DELETE), false) == Action::clear_selection);
    CHECK_FALSE(action_of(key(SDLK_x), true));
}

TEST_CASE("letters typed into a field are not keys", "[ui]") {
    app::Input input;
    input.handle(press(SDLK_r), true, height);
    input.handle(press(SDLK_ESCAPE), true, height);
    input.handle(press(SDLK_RETURN), true, height);
    CHECK(input.take_commands().empty());
    input.handle(press(SDLK_r), false, height);
    CHECK(input.take_commands().size() == 1);
    CHECK(input.take_commands().empty());
}

TEST_CASE("a drag that begins on a panel does not turn the camera, wherever it goes", "[ui]") {
    const vec3 box(4.0f);
    const view::Camera start = view::home(box);
    const auto after_drag = [&](bool began_on_panel, Uint8 which) {
        app::Input input;
        input.handle(button(SDL_MOUSEBUTTONDOWN, which), false, height);
        input.handle(motion(60, 20), false, height);
        view::Camera camera = input.moved(start, box, 0.0f, false, began_on_panel);
        input.handle(motion(40, 30), false, height);  // now over the other of the two
        camera = input.moved(camera, box, 0.0f, false, !began_on_panel);
        input.handle(button(SDL_MOUSEBUTTONUP, which), false, height);
        input.handle(motion(500, 500), false, height);  // released: no more
        return input.moved(camera, box, 0.0f, false, false);
    };
    const view::Camera still = after_drag(true, SDL_BUTTON_LEFT);
    CHECK(still.yaw == start.yaw);
    CHECK(still.position == start.position);

    const view::Camera looked = after_drag(false, SDL_BUTTON_LEFT);
    CHECK(looked.yaw != start.yaw);
    CHECK(looked.position == start.position);
    const view::Camera expected = view::look(start, view::vec2(100.0f, 50.0f) / static_cast<float>(height));
    CHECK(looked.yaw == Approx(expected.yaw));
    CHECK(looked.pitch == Approx(expected.pitch));

    const view::Camera panned = after_drag(false, SDL_BUTTON_RIGHT);
    CHECK(panned.yaw == start.yaw);
    CHECK(panned.position != start.position);
}

TEST_CASE("the wheel over a panel scrolls the panel", "[ui]") {
    const vec3 box(4.0f);
    const view::Camera start = view::home(box);
    SDL_Event wheel{};
    wheel.type = SDL_MOUSEWHEEL;
    wheel.wheel.preciseY = 1.0f;
    app::Input input;
    input.handle(wheel, false, height);
    CHECK(input.moved(start, box, 0.0f, false, true).position == start.position);
    CHECK(input.moved(start, box, 0.0f, false, false).position == start.position);
    input.handle(wheel, false, height);
    CHECK(input.moved(start, box, 0.0f, false, false).position != start.position);
}
