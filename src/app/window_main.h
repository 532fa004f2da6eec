// The window: one loop that owns everything in it. Its parts are files of their own; this one says how they hang
// together. window.cpp runs the loop, window_look.cpp looks and draws, window_commands.cpp does what is asked for.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "app/clock.h"
#include "app/input.h"
#include "app/panel_layer.h"
#include "app/window.h"
#include "app/window_budget.h"
#include "app/window_camera.h"
#include "app/window_costs.h"
#include "app/window_explorer.h"
#include "app/window_extremes.h"
#include "app/window_gui.h"
#include "app/window_inspector.h"
#include "app/window_keeper.h"
#include "app/window_laws.h"
#include "app/window_meters.h"
#include "app/window_monitor.h"
#include "app/window_picture.h"
#include "app/window_place.h"
#include "app/window_play.h"
#include "app/window_session.h"
#include "app/window_share.h"
#include "app/window_stepping.h"
#include "app/window_timings.h"
#include "app/window_views.h"
#include "gl/context.h"
#include "gl/timer.h"
#include "ui/commands.h"
#include "view/overlay.h"

namespace ballpit::app {

using SteadyClock = std::chrono::steady_clock;

inline constexpr int settling_frames = 3;  // after an event: panels answer a frame later than they are asked

inline double seconds_between(SteadyClock::time_point from, SteadyClock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
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
    void draw_panels(int width, int height);
    ui::State make_state();
    void choose_substeps(measure::BudgetPreset preset);
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
    void act(const ui::HideWarnings&) { extremes_.hide(); }
    void act(const ui::RelaxOverlaps&) { session_.relax(); }
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
    void act(const ui::RestartMeters&) { meters_.restart(); }
    void act(const ui::ChangeBudget& command) { budget_.choose(command.options); }
    void act(const ui::MeasureLaws&) { laws_.measure_again(); }
    void act(const ui::StartSweep&) { explorer_.start(session_); }
    void act(const ui::StartCosts&) { costs_.start(session_); }
    void act(const ui::StopCosts&) { costs_.stop(); }
    void act(const ui::StopSweep&) { explorer_.stop(); }
    void act(const ui::ChooseMetric& command) { explorer_.choose(command.metric); }
    void act(const ui::ExportSlot& command) { views_.export_slot(command.slot, inspector_, session_); }

    gl::Context context_;
    Gui gui_;
    Session session_;
    WindowPicture picture_;
    std::optional<PanelLayer> panel_layer_;  // where a CPU draws
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
    WindowMeters meters_;
    WindowBudget budget_{meters_};
    WindowExtremes extremes_;
    WindowExplorer explorer_;
    WindowCosts costs_;
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

}  // namespace ballpit::app
