// What was read back of the buffers for the panels that look into them, and what follows from it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "core/schedule.h"

namespace ballpit::ui {

/// A copy of a slot. Empty where no copy is there: nobody asked for one, it has not arrived, or the slot has no room.
struct SlotCopy {
    std::span<const std::byte> bytes;
    std::uint64_t revision = 0;  // copies of one revision are of one moment
    double age_s = 0.0;          // 0: as the buffer is now
};

struct Inspection {
    std::array<SlotCopy, slot_count> slots;
    std::span<const std::byte> keys_before;  // Slot::keys before the sort pass that ran last; empty where none did
    double read_ms = 0.0;                    // what the last reading cost
    double age_s = 0.0;                      // of the oldest copy
    std::optional<std::uint32_t> ball;       // selected
    std::optional<std::uint32_t> cell;

    const SlotCopy& slot(Slot which) const { return slots[static_cast<std::size_t>(which)]; }
};

}  // namespace ballpit::ui
