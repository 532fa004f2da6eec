// F7: how much may be wrong, what is, and how many substeps it takes.
#pragma once

#include "ui/commands.h"
#include "ui/state.h"

namespace ballpit::ui {

/// In the side panel: the way to the window.
void budget_section(const State& state, Commands& commands);

/// Content of the window; needs State::budget.
void budget_panel(const State& state, Commands& commands);
/// The window, where it is open.
void draw_budget_window(const State& state, Commands& commands);

}  // namespace ballpit::ui
