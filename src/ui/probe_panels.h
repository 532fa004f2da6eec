// The panels that look into grid, neighbours and buffers. As all panels: const state in, commands out.
#pragma once

#include <string>
#include <vector>

#include "ui/commands.h"
#include "ui/state.h"

namespace ballpit::ui {

/// In the side panel: what is open, what is drawn, how often copies are taken.
void probe_section(const State& state, Commands& commands);

void follow_panel(const State& state, Commands& commands);
void cells_panel(const State& state, Commands& commands);
void buffers_panel(const State& state, Commands& commands);
void split_panel(const State& state, Commands& commands);
void split_counts(const SplitSide& side);
void legend_panel(const Legend& legend);

/// One arrow of a ball's way: what it says, and the element that it leads to.
struct TraceLink {
    std::string text;
    Slot slot = Slot::positions;
    std::uint64_t element = 0;
};
/// `ball 73 → cell 61 204 → slot 4 410 → neighbours 4 402…4 417 → Δv (…) m/s`, as far as the substep has got.
std::vector<TraceLink> trace_links(const measure::BallProbe& probe, bool within_substep);

/// Every window of these panels that the state shows.
void draw_probe_windows(const State& state, Commands& commands);

}  // namespace ballpit::ui
