// What the parts of the strip share.
#pragma once

#include <vector>

#include "ui/stepping_panels.h"
#include "ui/strip_layout.h"

namespace ballpit::ui {

// What every row of the strip draws from.
struct Strip {
    const State& state;
    const SteppingState& stepping;
    Commands& commands;
    std::vector<StripChip> chips;
    float width = 0.0f;

    std::uint32_t dispatches() const { return static_cast<std::uint32_t>(stepping.schedule->dispatches.size()); }
    vec3 colour(Stage stage) const { return stepping.stage_colours[static_cast<std::size_t>(stage)]; }
    void go_to(std::uint32_t substep, std::uint32_t ran) const {
        commands.push_back(GoTo{{{stepping.place.substep.step, substep}, ran}});
    }
};

/// Rows of the strip with controls: at its top, below the sentence, and at its bottom.
void strip_header(const Strip& strip);
void strip_sliders(const Strip& strip);
void strip_footer(const Strip& strip);

}  // namespace ballpit::ui
