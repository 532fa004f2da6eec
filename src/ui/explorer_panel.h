// F8: speed against accuracy, measured for the scene that runs.
#pragma once

#include "ui/commands.h"
#include "ui/state.h"

namespace ballpit::ui {

/// Content of the window; needs State::explorer.
void explorer_panel(const State& state, Commands& commands);
/// The window, where it is open.
void draw_explorer_window(const State& state, Commands& commands);

}  // namespace ballpit::ui
