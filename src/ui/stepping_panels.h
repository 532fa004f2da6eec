// The panels to look inside a step: the strip of dispatches, the microscope of the sort, and what a check found.
#pragma once

#include <imgui.h>

#include <string>

#include "ui/commands.h"
#include "ui/state.h"

namespace ballpit::ui {

/// All three need State::stepping.
void stepper_strip(const State& state, Commands& commands);
void microscope_panel(const State& state, Commands& commands);
void differences_panel(const State& state, Commands& commands);

/// The windows that hold them.
void draw_stepping_windows(const State& state, Commands& commands);
/// Pixels that the strip takes at the bottom of the window; 0 while it is closed.
float strip_height(const State& state);
/// The same for the strip and what stands above it: the microscope, or the table of differences.
float covered_height(const State& state);

/// Pixels of the window of differences, at most.
float differences_height(const State& state);

/// A shape and words: a meaning that no eye misses.
std::string badge_text(const Badge& badge);
ImVec4 badge_colour(Badge::Kind kind);

}  // namespace ballpit::ui
