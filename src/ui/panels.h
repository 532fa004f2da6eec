// The panels. Each is a pure function: it reads the state, draws its content into the window that is open, and
// appends what the user asks for. `draw_panels` lays them all out.
#pragma once

#include "ui/commands.h"
#include "ui/state.h"

namespace ballpit::ui {

void scene_panel(const State& state, Commands& commands);
void run_panel(const State& state, Commands& commands);
void settings_panel(const State& state, Commands& commands);
void view_panel(const State& state, Commands& commands);
/// Needs State::play.
void play_section(const State& state, Commands& commands);
void light_panel(const State& state, Commands& commands);

void frame_rate_panel(const State& state);
void message_panel(const State& state, Commands& commands);
void status_panel(const State& state, Commands& commands);
void warnings_panel(const State& state, Commands& commands);
void timings_panel(const State& state);
void occupancy_panel(const State& state);
void share_panel(const State& state, Commands& commands);
void replay_panel(const State& state);
void hash_corner(const State& state);
void help_page(const State& state, Commands& commands);

/// Every panel that the state shows, between ImGui::NewFrame() and ImGui::Render().
void draw_panels(const State& state, Commands& commands);

/// Width that the side panel and its margins take from the picture, in points; inside a frame.
float side_panel_width();

/// Height of the corner with the state hash, in pixels; inside a frame.
float hash_corner_height(const State& state);

/// Whether there is a failure to show in red.
inline bool has_failure(const State& state) { return state.status.bits != 0; }
/// Whether there is something to warn of.
bool has_warning(const State& state);

}  // namespace ballpit::ui
