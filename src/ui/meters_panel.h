// F6: where the energy goes, what is metered beside it, and how far the scene is from the edge.
#pragma once

#include "ui/commands.h"
#include "ui/state.h"

namespace ballpit::ui {

/// In the side panel: the way to the window.
void meters_section(Commands& commands);

/// Content of the window; needs State::meters.
void meters_panel(const State& state, Commands& commands);
/// The window, where it is open.
void draw_meters_window(const State& state, Commands& commands);

}  // namespace ballpit::ui
