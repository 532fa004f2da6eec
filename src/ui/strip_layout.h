// Where the strip draws its marks: pure functions of counts and a width.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/schedule.h"

namespace ballpit::ui {

/// A substep among those of its step.
struct StripBlock {
    std::uint32_t substep = 0;
    float left = 0.0f;
    float right = 0.0f;
};

/// The blocks of a step; where they would be narrower than `narrowest`, only those around the one shown.
std::vector<StripBlock> substep_blocks(std::uint32_t substeps, std::uint32_t shown, float width, float narrowest);

/// Consecutive dispatches of one stage: [first, last).
struct StripChip {
    Stage stage{};
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    float left = 0.0f;
    float right = 0.0f;
};

/// The stages of a substep in the order in which they run. Each has room for its name; what is left goes to those with
/// many dispatches.
std::vector<StripChip> stage_chips(const Schedule& schedule, float width, float gap);

/// The mark of a dispatch within its chip.
struct StripMark {
    float left = 0.0f;
    float right = 0.0f;
};
StripMark mark_of(const StripChip& chip, std::uint32_t dispatch);
/// The dispatch whose mark lies at x; none beside the chip.
std::optional<std::uint32_t> dispatch_at(const StripChip& chip, float x);

}  // namespace ballpit::ui
