#include "app/window.h"

#include <SDL.h>

#include <algorithm>
#include <utility>

#include "app/budget.h"
#include "app/user_folders.h"
#include "app/window_main.h"
#include "app/window_overlay.h"
#include "core/error.h"
#include "gl/reset.h"
#include "gl/software.h"
#include "ui/panels.h"
#include "view/palette.h"

namespace ballpit::app {

namespace {

constexpr int idle_wait_ms = 250;        // a paused window looks for news this often, and at once for any event
constexpr Uint32 shortest_frame_ms = 4;  // where the display does not hold frames back, this does

gl::ContextOptions context_options(const WindowOptions& options) {
    // Windows else scales a picture made for fewer pixels, which blurs text. Other systems do not know the hint.
    SDL_SetHint("SDL_WINDOWS_DPI_SCALING", "1");
    gl::ContextOptions context;
    context.width = options.width;
    context.height = options.height;
    return context;
}

// Whether the next event ends a press. In a slow frame a press and its end come together; older versions of ImGui look
// only at what is down when a frame begins, and would never see it: then the end waits for the next frame.
bool release_comes_next() {
    SDL_PumpEvents();
    SDL_Event next;
    return SDL_PeepEvents(&next, 1, SDL_PEEKEVENT, SDL_FIRSTEVENT, SDL_LASTEVENT) == 1 &&
           (next.type == SDL_KEYUP || next.type == SDL_MOUSEBUTTONUP);
}

}  // namespace

Window::Window(const WindowOptions& options)
    : context_(context_options(options)),
      gui_(context_, options.assets_folder / "fonts" / "DejaVuSans.ttf"),
      session_(options, context_.has_compute(), context_.version(), gl::draws_in_software(context_.renderer())),
      picture_(options.shader_folder, options.model_file, gl::draws_in_software(context_.renderer())),
      keeper_(options.user_folder, options.user) {
    SDL_GL_SetSwapInterval(1);
    if (gl::draws_in_software(context_.renderer())) {
        panel_layer_.emplace(options.shader_folder);
    }
    remember(options.user);
    message_ = options.message;
    if (options.budget) {
        choose_substeps(*options.budget);
    }
    if (options.relax) {
        session_.relax();
    }
    if (!options.code.empty()) {
        sharing_.open_code(options.code);
    }
}

void Window::choose_substeps(measure::BudgetPreset preset) {
    Settings settings;
    const auto twin = session_.twin_backend();
    tell(preset, apply_budget(preset, session_.simulation(), *twin, settings));
    budget_.choose({budget_of(preset), preset == measure::BudgetPreset::historical});
    session_.want(settings);
}

// As it was when it was closed.
void Window::remember(const UserSettings& user) {
    place_ = user.place.value_or(place_of(context_.window()));
    if (user.place) {
        put(context_.window(), *user.place);
    }
    if (user.full_screen) {
        toggle_full_screen();
    }
    if (user.shown) {
        view_ = user.shown->view;
        light_ = light_of(user.shown->light);
        views_.act(ui::ChangeProbe{user.shown->probe});
    }
    text_size_ = static_cast<float>(user.text_size);
    speed_ = user.speed;
    gui_.set_layout(user.layout);
}

UserSettings Window::to_remember() const {
    UserSettings user;
    user.place = full_screen_ ? place_ : place_of(context_.window());
    user.full_screen = full_screen_;
    user.text_size = static_cast<double>(text_size_);
    user.speed = speed_;
    user.shown = Shown{view_, views_.probe_options(), light_options(light_)};
    user.shown->light.angle = view::Light().angle;  // it goes round
    user.shown->probe.split = false;                // costs what a second simulation costs
    user.shown->view.help = false;
    user.layout = gui_.layout();
    session_.describe(user);
    return user;
}

void Window::keep(double now_s) {
    if (keeper_.due(now_s) && !sharing_.replaying()) {
        keeper_.update(to_remember(), now_s);
    }
}

int Window::run() {
    try {
        while (!quit_) {
            wait_for_events();
            handle_events();
            if (!hidden()) {
                frame();
            }
            gl::expect_context();
        }
    } catch (const std::exception&) {  // whatever a device that is gone made of it
        if (const auto reason = gl::reset_reason()) {
            keeper_.finish(to_remember());
            throw DeviceError(*reason + ". " + session_.rescue(data_folder()));
        }
        throw;
    }
    keeper_.finish(to_remember());
    return 0;
}

bool Window::hidden() const {
    return (SDL_GetWindowFlags(context_.window()) & (SDL_WINDOW_MINIMIZED | SDL_WINDOW_HIDDEN)) != 0;
}

// A window that nobody sees, or in which nothing moves, must not heat the room.
void Window::wait_for_events() {
    const bool still = !clock_.running() && clock_.state() != RunState::one_step && settling_ == 0 &&
                       !inspector_.waiting() && !sharing_.working() && !views_.working() && !laws_.working() &&
                       !budget_.working() && !explorer_.working(view_.explorer) && !costs_.working(view_.costs) &&
                       !camera_.flying() && !input_.active(gui_.typing()) && !blinks(overlay_);
    if (!hidden() && !still) {
        return;
    }
    const auto before = SteadyClock::now();
    SDL_WaitEventTimeout(nullptr, idle_wait_ms);
    waited_s_ += seconds_between(before, SteadyClock::now());
}

void Window::handle_events() {
    int height = 1;
    SDL_GetWindowSize(context_.window(), nullptr, &height);
    SDL_Event event;
    bool pressed = false;
    while (!(pressed && release_comes_next()) && SDL_PollEvent(&event) != 0) {
        settling_ = settling_frames;
        gui_.process(event);
        input_.handle(event, gui_.typing(), std::max(height, 1));
        pressed |= event.type == SDL_MOUSEBUTTONDOWN || (event.type == SDL_KEYDOWN && gui_.typing());
        if (event.type == SDL_QUIT) {
            quit_ = true;
        } else if (event.type == SDL_DROPFILE) {
            const std::unique_ptr<char, decltype(&SDL_free)> file(event.drop.file, &SDL_free);
            sharing_.open_file(file.get());
        }
    }
    carry_out(input_.take_commands());
}

void Window::frame() {
    const auto now = SteadyClock::now();
    const double wall_s = seconds_between(frame_start_, now);
    const double busy_s = std::max(wall_s - std::exchange(waited_s_, 0.0), 0.0);
    frame_start_ = now;

    session_.apply(gui_.holding());
    if (view_.occupancy || views_.needs_cells(view_, inspection_)) {
        session_.prepare_cells();
    }
    const int steps = advance(busy_s);
    look_inside(seconds_between(start_, now));
    laws_.update(session_, view_.laws, seconds_between(start_, now), 1000.0 * busy_s);
    meters_.update(session_, view_.meters);
    budget_.update(session_, view_.budget, seconds_between(start_, now), 1000.0 * busy_s, timings_.substep_ms());
    explorer_.update(view_.explorer, 1000.0 * busy_s);
    costs_.update(view_.costs);
    measure_times(busy_s, wall_s, steps * session_.simulation().settings().dt);
    for (std::string message : {views_.take_message(), laws_.take_message(), budget_.take_message(),
                                explorer_.take_message(), costs_.take_message(), play_.take_message(),
                                session_.take_message(), sharing_.take_message(), keeper_.take_message()}) {
        if (!message.empty()) {
            message_ = std::move(message);
        }
    }

    gui_.begin_frame(text_size_);
    move_camera(static_cast<float>(std::min(busy_s, 0.1)));
    sharing_.update();
    keep(seconds_between(start_, now));
    const ui::State state = make_state();
    ui::Commands commands;
    ui::draw_panels(state, commands);
    close_popups_ = false;
    draw();
    update_title();
    SDL_GL_SwapWindow(context_.window());
    laws_.build_ahead(session_);
    const auto spent_ms = static_cast<Uint32>(1000.0 * seconds_between(now, SteadyClock::now()));
    if (spent_ms < shortest_frame_ms) {
        SDL_Delay(shortest_frame_ms - spent_ms);
    }
    settling_ = commands.empty() ? std::max(settling_ - 1, 0) : settling_frames;
    carry_out(commands);
}

int Window::advance(double wall_s) {
    const int steps = clock_.steps_for_frame(wall_s, session_.simulation().settings().dt, speed_);
    for (int i = 0; i < steps; ++i) {
        session_.step();
    }
    if (clock_.running()) {
        light_ = view::advance(light_, static_cast<float>(wall_s));
    }
    return steps;
}

ui::State Window::make_state() {
    ui::State state;
    session_.describe(state);
    state.running = clock_.running();
    state.speed = speed_;
    state.achieved = frame_rate_.achieved_speed();
    state.view = view_;
    state.light = light_options(light_);
    state.text_size = text_size_;
    state.full_screen = full_screen_;
    state.fps = frame_rate_.fps();
    state.frame_ms = frame_rate_.frame_ms();
    state.timings = timings_.rows();
    state.status = monitor_.status();
    state.occupancy = monitor_.occupancy();
    state.top_count = monitor_.top_count();
    state.amount_colour = view::sequential;
    state.which_colour = view::categorical;
    state.stepping = &stepping_.state();
    state.inspection = &inspection_;
    views_.describe(probe_, session_, inspection_, view_, monitor_.top_count());
    state.probe = &probe_;
    state.share = &sharing_.state();
    state.play = &play_.describe(session_);
    state.laws = laws_.describe(session_, view_.laws);
    state.meters = meters_.describe(session_, view_.meters);
    state.budget = budget_.describe(session_, view_.budget);
    state.explorer = explorer_.describe(session_, view_.explorer, budget_.options().budget);
    state.costs = costs_.describe(session_, view_.costs);
    extremes_.describe(session_, clock_,
                       state.meters != nullptr && state.meters->record ? &*state.meters->record : nullptr, state);
    state.message = message_;
    state.close_popups = close_popups_;
    return state;
}

void Window::update_title() {
    const Simulation& simulation = session_.simulation();
    // Plain ASCII: without a UTF-8 locale some window managers would not show the title at all.
    const std::string title =
        simulation.scene().name + " - " + std::to_string(simulation.schedule().ball_count) + " balls - Ball Pit";
    if (title != title_) {
        title_ = title;
        SDL_SetWindowTitle(context_.window(), title_.c_str());
    }
}

int run_window(const WindowOptions& options) { return Window(options).run(); }

}  // namespace ballpit::app
