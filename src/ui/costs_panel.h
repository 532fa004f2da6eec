// F9: what a substep costs against the number of balls, measured for the scene that runs.
#pragma once

#include "ui/commands.h"
#include "ui/state.h"

namespace ballpit::ui {

/// "bitonic_fused: 0.43 ms at 65 536 balls, slope 1.02".
std::string cost_line_text(const CostLine& line);

/// Content of the window; needs State::costs.
void costs_panel(const State& state, Commands& commands);
/// The window, where it is open.
void draw_costs_window(const State& state, Commands& commands);

}  // namespace ballpit::ui
