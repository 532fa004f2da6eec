// F4: the laws of the scene that runs, what each changes, asks for and costs.
#pragma once

#include "ui/commands.h"
#include "ui/state.h"

namespace ballpit::ui {

/// In the side panel: what holds, and the way to the window.
void laws_section(const State& state, Commands& commands);

/// Content of the window; needs State::laws.
void laws_panel(const State& state, Commands& commands);
/// The window, where it is open.
void draw_laws_window(const State& state, Commands& commands);

}  // namespace ballpit::ui
