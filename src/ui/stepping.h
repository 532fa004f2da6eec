// Where the run stands inside a step, as plain data for the panels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/schedule.h"
#include "core/stepper.h"
#include "core/vector.h"
#include "measure/stage_numbers.h"
#include "ui/live_check.h"

namespace ballpit::ui {

/// The substep that the strip shows, and how many of its dispatches have run: 0 to all of them. All of them is the
/// moment at which the next substep begins, seen from behind: what ran last is what is lit and spoken of.
struct Place {
    Moment substep;
    std::uint32_t ran = 0;
    friend auto operator<=>(const Place&, const Place&) = default;
};

struct SteppingState {
    Place place;
    std::uint32_t substeps = 1;          // of the step shown
    const Schedule* schedule = nullptr;  // of the substep shown, pass by pass; never null
    std::uint32_t grid_reuse = 1;        // substeps that use one grid
    std::uint32_t building = 0;          // dispatches of a substep that builds its grid
    std::uint32_t using_again = 0;       // of one that uses an earlier one's
    StepUnit unit = StepUnit::step;
    std::uint64_t first_step = 0;     // steps done at the start of what is remembered
    std::uint64_t furthest_step = 0;  // the most steps that were ever done since

    std::uint64_t hash_step = 0;        // steps done when the state had this hash
    std::optional<std::uint64_t> hash;  // arrives late
    std::optional<Divergence> divergence;

    std::size_t checkpoint_bytes = 0;
    std::size_t checkpoint_budget = 0;
    std::size_t checkpoint_count = 0;

    measure::StageNumbers numbers;                  // of the dispatch that ran last; nothing while the simulation runs
    std::array<vec3, stage_count> stage_colours{};  // sRGB
    LiveCheckState check;
};

}  // namespace ballpit::ui
