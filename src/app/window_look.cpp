// What the window looks into, how it is drawn, and from where.
#include <SDL.h>

#include <algorithm>

#include "app/room.h"
#include "app/window_main.h"
#include "app/window_overlay.h"
#include "ui/panels.h"
#include "ui/stepping_panels.h"

namespace ballpit::app {

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
    draw_panels(width, height);
    if (view_.timings) {
        draw_timer_.mark(1);
        draw_timer_.end();
    }
}

void Window::draw_panels(int width, int height) {
    gui_.end_frame();
    if (!panel_layer_) {
        gui_.render();
        return;
    }
    const double now_s = seconds_between(start_, frame_start_);
    const bool lively = settling_ > 0 || !clock_.running() || gui_.holding();
    if (panel_layer_->due(lively, now_s, width, height)) {
        panel_layer_->draw(now_s, width, height);
    }
    panel_layer_->lay_over();
}

void Window::measure_times(double busy_s, double wall_s, double simulated_s) {
    Backend& backend = session_.simulation().backend();
    backend.set_timing(view_.timings || view_.budget || views_.split());
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

}  // namespace ballpit::app
