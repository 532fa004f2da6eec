// A dispatch that could take seconds is cut into slices of balls, so that no driver's watchdog takes it for a hang.
// Each ball has a thread to itself and reads only what is there before: slices change no bit, and the schedule, the
// stage strip and the mirror know nothing of them. Pure functions; the executor on the GPU asks them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/schedule.h"

namespace ballpit {

/// Pairs that one dispatch may look at: some 10 ms of a large GPU, some 0.1 s of a laptop's. Watchdogs wait for 2 s.
inline constexpr double pairs_a_slice = 268435456.0;

/// Balls from `first` on, as many as the groups have threads.
struct Slice {
    std::uint32_t first = 0;  // constant w of the dispatch
    Groups groups;
};

/// How many cells of balls each thread of it looks at; 0 where it does not look at other balls.
double cells_looked_at(const Program& program);

/// Whether each thread of it looks at other balls.
inline bool looks_at_pairs(const Program& program) { return cells_looked_at(program) > 0.0; }

/// How dense balls lie where balls are: per m^3 in the cell of a ball, averaged over the balls. Positions that are
/// no numbers count for the grid's first cell.
double local_density(std::span<const vec4> positions, const Grid& grid);

inline constexpr double cells_around = 27.0;  // a ball, its own included

/// Pairs that a dispatch looks at, about: all with brute force, else those of so many cells as dense as that.
double pairs_of(const Schedule& schedule, double density, double cells = cells_around);

/// `count` slices that cover the balls, or as many as there are groups; whole groups each, but for the last one.
std::vector<Slice> slices_of(std::uint32_t ball_count, std::uint32_t count);

}  // namespace ballpit
