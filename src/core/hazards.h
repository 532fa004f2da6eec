// Which barrier a use of a buffer needs. What a shader wrote becomes visible to another use only through a barrier with
// the bit of *that use*; guessing the bits is how stale data gets drawn. Pure bookkeeping: the executor on the GPU
// asks it, and so does whoever wants to know what a schedule costs without running it.
#pragma once

#include <array>
#include <cstdint>

#include "core/schedule.h"

namespace ballpit {

/// What the next command does with a buffer that a shader may have written.
enum class Use : std::uint8_t { storage, vertex, texture, copy };
inline constexpr std::size_t use_count = 4;

/// A set of uses.
using Uses = std::uint32_t;
constexpr Uses only(Use use) { return 1u << static_cast<unsigned>(use); }
inline constexpr Uses all_uses = (1u << use_count) - 1;

/// Keeps, for each buffer, the uses to which its last shader write is not yet visible, and whether a shader may still
/// be reading it. A slot is a role that a buffer plays, and roles can be exchanged.
class Hazards {
public:
    Hazards();

    /// The buffer that plays this role, from 0 to slot_count - 1.
    std::size_t physical(Slot slot) const { return buffers_[static_cast<std::size_t>(slot)]; }
    /// positions and next_positions, velocities and next_velocities.
    void swap_states();
    /// next_positions and sorted_positions, next_velocities and sorted_velocities.
    void swap_copies();

    /// The uses that a barrier must name before the slot is used so; none where nothing is pending.
    Uses before_use(Slot slot, Use use) const { return pending_[physical(slot)] & only(use); }
    /// The same before all reads and writes of a dispatch: earlier writes must be visible, and slots that it
    /// writes no longer be read.
    Uses before(const Dispatch& dispatch) const;

    /// A barrier with these uses was issued: it covers every buffer.
    void issued(Uses uses);
    void ran(const Dispatch& dispatch);
    /// A shader that is no part of a schedule was told to read the slot.
    void shader_reads(Slot slot) { read_[physical(slot)] = true; }

private:
    void swap(Slot a, Slot b);

    std::array<std::size_t, slot_count> buffers_{};
    std::array<Uses, slot_count> pending_{};
    std::array<bool, slot_count> read_{};
};

}  // namespace ballpit
