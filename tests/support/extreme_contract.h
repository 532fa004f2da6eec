// What the physics promises at the extremes, for any backend that runs in single.
#pragma once

#include <functional>
#include <memory>

#include "core/backend.h"

namespace ballpit::test {

using BackendMaker = std::function<std::unique_ptr<Backend>()>;

/// Balls that become no number, infinite or too fast to be squared go into quarantine; every other ball goes on as if
/// those had been there in quarantine already, bit for bit.
void quarantine_leaves_the_others_alone(const BackendMaker& make);
/// A ball far outside comes back, no faster than the capped spring throws it, and is counted until it is back.
void walls_push_no_harder_than_their_cap(const BackendMaker& make);
/// Two balls with one centre are counted once a substep and part with no momentum.
void coincident_balls_are_counted(const BackendMaker& make);
/// A ball that moves by more than its radius is counted in every substep.
void too_fast_balls_are_counted(const BackendMaker& make);
/// Nothing changes in steps of no time, neither -0 nor a counter.
void no_time_changes_no_bit(const BackendMaker& make);
/// A dashpot far beyond what an explicit one allows: semi-implicit it comes to rest at m g / k, and momentum stays.
void semi_implicit_dashpots_hold(const BackendMaker& make);
/// Deep overlaps are pushed apart; velocities, step and time stay as they were.
void relaxing_parts_balls(const BackendMaker& make);

}  // namespace ballpit::test
