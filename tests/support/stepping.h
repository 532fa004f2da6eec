// What stepping is held to on every backend: back gives the bytes that were there before.
#pragma once

#include <memory>

#include "core/simulation.h"

namespace ballpit::test {

/// A few dozen balls in a box with every law, two substeps a step.
Simulation stepping_simulation(std::unique_ptr<Backend> backend, SortMethod sort);

/// From each dispatch of two steps back in each unit, and forth again: the bytes of every slot as when they were first
/// there.
void check_every_position(Simulation& simulation);

/// Everything that a user can do on the way: walls that move, a box that is shaken, a ball that is pulled, balls thrown
/// in and taken away, laws ticked (in place and not), integrator, sort. Then forth and back over every dispatch.
void check_changes_at_every_position(Simulation& simulation);

/// 300 steps forth, changing settings on the way, back to the start, and forth again.
void check_long_way(Simulation& simulation, std::uint64_t steps);

}  // namespace ballpit::test
