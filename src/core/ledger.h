// What a scene costs before it runs: bytes, dispatches, barriers, bindings. All of it follows from the schedule, so
// that `ballpit scenes --ledger` needs no device; tests hold the backends to it.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/schedule.h"

namespace ballpit {

/// Bytes that a backend keeps for each slot.
std::array<std::size_t, slot_count> bytes_of(const Schedule& schedule);

/// Of those the slots that grow with the number of balls (all but the cell table, what is kept for its tiles, and the
/// status word), a ball.
double bytes_per_ball(const Schedule& schedule);

/// Bytes that a dispatch cannot do without moving: each slot that it reads or writes as a whole, once. Not counted is
/// what depends on the state: which cells are looked at or have balls, which keys of a pass change places.
std::size_t least_bytes(const Dispatch& dispatch, const Schedule& schedule);
/// The same of all dispatches of a stage.
std::size_t least_bytes(const Schedule& schedule, Stage stage);

/// Barriers of one substep among many, with nothing looked at in between.
struct BarrierCount {
    std::uint32_t before = 0;  // 1 where the first dispatch waits for the substep before
    std::uint32_t within = 0;
};
BarrierCount count_barriers(const Schedule& schedule);

/// Dispatches of one stage.
std::uint32_t dispatches_of(const Schedule& schedule, Stage stage);

/// The slots that some dispatch of the schedule binds, in their order.
std::vector<Slot> bound_slots(const Schedule& schedule);

/// What the substep does without, "no grid, no sort, ...": one phrase for each thing that is not there.
std::vector<std::string> absences(const Schedule& schedule);

}  // namespace ballpit
