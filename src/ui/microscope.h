// Which slots the microscope of the sort shows, and what it says about one of them: pure functions.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/layout.h"
#include "ui/stepping.h"

namespace ballpit::ui {

/// The sort pass that ran last, if a pass did.
struct ShownPass {
    std::uint32_t k = 0;
    std::uint32_t j = 0;
};
std::optional<ShownPass> shown_pass(const SteppingState& stepping);

/// Slots from left to right. Where the partners of a pass lie further apart than the window is wide, its right half
/// shows the partners of its left half.
struct SlotWindow {
    std::vector<std::uint32_t> slots;
    std::size_t split = 0;  // the index at which a gap is; 0: none
};
SlotWindow slot_window(std::uint32_t key_count, std::uint32_t wanted, std::uint32_t first, std::uint32_t j);

/// Sentences about a slot: what it holds, and with a pass its thread, partner, direction and why, swapped or not.
std::string slot_story(std::uint32_t slot, const std::optional<ShownPass>& pass, std::span<const Key> keys,
                       std::span<const Key> before);

}  // namespace ballpit::ui
