#include "app/window.h"

#include <SDL.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <utility>
#include <variant>

#include "app/clock.h"
#include "app/input.h"
#include "app/room.h"
#include "app/window_camera.h"
#include "app/window_gui.h"
#include "app/window_inspector.h"
#include "app/window_keeper.h"
#include "app/window_laws.h"
#include "app/window_monitor.h"
#include "app/window_overlay.h"
#include "app/window_picture.h"
#include "app/window_place.h"
#include "app/window_play.h"
#include "app/window_session.h"
#include "app/window_share.h"
#include "app/window_stepping.h"
#include "app/window_timings.h"
#include "app/window_views.h"
#include "core/error.h"
#include "gl/context.h"
#include "gl/timer.h"
#include "ui/panels.h"
#include "ui/stepping_panels.h"
#include "view/palette.h"

namespace ballpit::app {

namespace {

using SteadyClock = std::chrono::steady_clock;

constexpr int idle_wait_ms = 250;        // a paused window looks for news this often, and at once for any event
constexpr int settling_frames = 3;       // after an event: panels answer a frame later than they are asked
constexpr Uint32 shortest_frame_ms = 4;  // where the display does not hold frames back, this does

double seconds_between(SteadyClock::time_point from, SteadyClock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
}

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

class Window {
public:
    explicit Window(const WindowOptions& options);
    int run();

private:
    bool hidden() const;
    void wait_for_events();
    void handle_events();
    void frame();
    int advance(double wall_s);
    void draw();
    ui::State make_state();
    void measure_times(double busy_s, double wall_s, double simulated_s);
    void look_inside(double now_s);
    void fly_to_selected_ball();
    void move_camera(float seconds);
    WindowExtent extent() const;
    Surroundings surroundings() const;
    Eye eye() const { return {camera_.camera(), extent(), views_.split()}; }
    void update_title();
    void remember(const UserSettings& user);
    UserSettings to_remember() const;
    void keep(double now_s);

    void carry_out(const ui::Commands& commands);
    void close_topmost();
    void toggle_full_screen();

    // One for each command; std::visit picks.
    void act(ui::Action action);
    void act(const ui::ChangeSettings& command);
    void act(const ui::ChooseScene& command) { session_.choose_scene(command.index); }
    void act(const ui::ChooseBackend& command) { session_.choose_backend(command.choice); }
    void act(const ui::ChangeSpeed& command) { speed_ = command.speed; }
    void act(const ui::ChangeView& command) { view_ = command.view; }
    void act(const ui::ChangeLight& command) { light_ = light_of(command.light); }
    void act(const ui::ChangeTextSize& command) { text_size_ = command.factor; }
    void act(const ui::ClearStatus&) { session_.clear_status(); }
    void act(const ui::DismissMessage&) { message_.clear(); }
    void act(const ui::ChooseUnit& command) { stepping_.act(command, view_); }
    void act(const ui::StepForward& command) { stepping_.act(command); }
    void act(const ui::StepBack& command) { stepping_.act(command); }
    void act(const ui::GoTo& command) { stepping_.act(command); }
    void act(const ui::SetCheckpointBudget& command) { stepping_.act(command); }
    void act(const ui::SetLiveCheck& command) { stepping_.act(command); }
    void act(const ui::ShowDifferences& command) { stepping_.act(command); }
    void act(const ui::SelectBall& command);
    void act(const ui::SelectCell& command) { views_.select_cell(command.cell, inspection_); }
    void act(const ui::SelectCellOfBall& command) { views_.select_cell_of_ball(command.ball, inspection_); }
    void act(const ui::ChangeProbe& command) { views_.act(command); }
    void act(const ui::ShowElement& command) { views_.act(command); }
    void act(const ui::CopyCode& command) { sharing_.act(command); }
    void act(const ui::NameFile& command) { sharing_.act(command); }
    void act(const ui::ChangePlay& command) { play_.choose(command.options); }
    void act(const ui::MeasureLaws&) { laws_.measure_again(); }
    void act(const ui::ExportSlot& command) { views_.export_slot(command.slot, inspector_, session_); }

    gl::Context context_;
    Gui gui_;
    Session session_;
    WindowPicture picture_;
    Clock clock_;
    Input input_;
    Monitor monitor_;
    WindowTimings timings_;
    FrameRate frame_rate_;
    gl::SpanTimer draw_timer_;

    Inspector inspector_;
    Views views_;
    ui::ProbeState probe_;
    Stepping stepping_{session_, clock_};
    WindowLaws laws_;
    Play play_;
    ui::Inspection inspection_;
    view::Overlay overlay_;
    bool flight_wanted_ = false;  // as soon as it is known where the ball is

    ui::ViewOptions view_;
    WindowCamera camera_;
    view::Light light_;
    Sharing sharing_{session_, clock_, {view_, light_, camera_, views_, inspection_}};
    Keeper keeper_;
    WindowPlace place_;  // when it last did not fill the screen
    double speed_ = 1.0;
    float text_size_ = 1.0f;
    bool full_screen_ = false;
    bool close_popups_ = false;
    std::string message_;
    std::string title_;

    bool quit_ = false;
    int scene_changes_ = 0;
    int settling_ = settling_frames;
    SteadyClock::time_point start_ = SteadyClock::now();
    SteadyClock::time_point frame_start_ = start_;
    double waited_s_ = 0.0;  // since the frame before, doing nothing
};

Window::Window(const WindowOptions& options)
    : context_(context_options(options)),
      gui_(context_, options.assets_folder / "fonts" / "DejaVuSans.ttf"),
      session_(options, context_.has_compute(), context_.version()),
      picture_(options.shader_folder, options.model_file),
      keeper_(options.user_folder, options.user) {
    SDL_GL_SetSwapInterval(1);
    remember(options.user);
    message_ = options.message;
    if (!options.code.empty()) {
        sharing_.open_code(options.code);
    }
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
    while (!quit_) {
        wait_for_events();
        handle_events();
        if (!hidden()) {
            frame();
        }
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
    measure_times(busy_s, wall_s, steps * session_.simulation().settings().dt);
    for (std::string message : {views_.take_message(), laws_.take_message(), play_.take_message(),
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

// What panels want to know of the buffers: see Inspector. A panel that is closed wants nothing.
void Window::look_inside(double now_s) {
    Monitor::ask(inspector_, view_.occupancy || views_.shows_slice());
    views_.want(inspector_, view_, inspection_);
    stepping_.want(inspector_, view_);
    if (flight_wanted_) {
        inspector_.want(Slot::positions);
    }
    inspector_.update(session_, clock_.running(), now_s);
    monitor_.update(inspector_, session_.simulation().schedule().ball_count);
    stepping_.update(inspector_, view_);
    inspector_.describe(inspection_, now_s);
    if (flight_wanted_) {
        fly_to_selected_ball();
    }
    views_.update(session_, inspector_, inspection_, view_, stepping_.state().check, clock_.running(), now_s);
    overlay_ = make_overlay(inspection_);
    views_.add_to(overlay_, inspection_, session_);
    play_.add_to(overlay_, session_);
}

void Window::fly_to_selected_ball() {
    const auto positions = typed<vec4>(inspection_.slot(Slot::positions).bytes);
    if (positions.empty()) {
        return;
    }
    flight_wanted_ = false;
    if (inspection_.ball && *inspection_.ball < positions.size()) {
        camera_.fly_to(positions[*inspection_.ball], surroundings());
    }
}

void Window::draw() {
    int width = 0;
    int height = 0;
    SDL_GL_GetDrawableSize(context_.window(), &width, &height);
    if (view_.timings) {
        draw_timer_.begin();
    }
    PictureOptions options;
    options.view = view_;
    options.camera = camera_.camera();
    options.light = light_;
    options.overlay = &overlay_;
    options.top_count = monitor_.top_count();
    options.time_s = static_cast<float>(seconds_between(start_, frame_start_));
    views_.draw(picture_, session_, options, extent(), width, height);
    if (view_.timings) {
        draw_timer_.mark(0);
    }
    gui_.end_frame();
    if (view_.timings) {
        draw_timer_.mark(1);
        draw_timer_.end();
    }
}

void Window::measure_times(double busy_s, double wall_s, double simulated_s) {
    Backend& backend = session_.simulation().backend();
    backend.set_timing(view_.timings || views_.split());
    const std::vector<StageTimes> times = backend.take_times();
    timings_.add_substeps(times);
    views_.add_grid_times(times);
    for (const gl::SpanTimer::Span& span : draw_timer_.take()) {
        timings_.add_frame(span[0].ms, span[1].ms);
    }
    if (frame_rate_.add(busy_s, wall_s, simulated_s)) {
        timings_.refresh();
    }
}

void Window::move_camera(float seconds) {
    if (session_.scene_changes() != scene_changes_) {
        scene_changes_ = session_.scene_changes();
        inspection_.ball.reset();
        inspection_.cell.reset();
        camera_.go_home();
    }
    camera_.update(input_, surroundings(), seconds, gui_.typing(), gui_.over_panel());
    play_.update(session_, input_, eye(), gui_.over_panel());
    if (play_.hand() && !gui_.over_panel()) {
        Gui::show_hand();
    }
    if (const auto click = input_.take_click()) {
        const bool control = (SDL_GetModState() & KMOD_CTRL) != 0;
        views_.pick(*click, control, extent(), camera_.camera(), session_, inspection_);
    }
}

WindowExtent Window::extent() const {
    int width = 1;
    int height = 1;
    SDL_GetWindowSize(context_.window(), &width, &height);
    const auto wide = static_cast<float>(std::max(width, 1));
    const float covered = view_.panels ? std::min(ui::side_panel_width(), 0.6f * wide) : 0.0f;
    const auto tall = static_cast<float>(std::max(height, 1));
    ui::State state;
    state.view = view_;
    state.stepping = &stepping_.state();
    return {wide, tall, wide - covered, tall - std::min(ui::covered_height(state), 0.75f * tall)};
}

Surroundings Window::surroundings() const {
    return {extent(), room_half_extent(session_.simulation()), views_.split()};
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

}  // namespace

int run_window(const WindowOptions& options) { return Window(options).run(); }

}  // namespace ballpit::app
