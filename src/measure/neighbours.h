// What the grid makes collide look at: pairs tested, contacts found and missed, and one ball's way through the
// buffers. Read from keys and cell ranges as the stages left them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/grid.h"
#include "core/layout.h"
#include "measure/pairs.h"

namespace ballpit::measure {

/// The buffers of one substep, after build_grid.
struct GridView {
    std::span<const vec4> positions;
    std::span<const Key> keys;  // sorted
    std::span<const CellRange> cell_ranges;
    Grid grid;
};

struct NeighbourReport {
    std::uint64_t tested = 0;    // ordered pairs (a, b) that collide computes a distance for
    std::uint32_t contacts = 0;  // touching pairs that the grid finds
    std::vector<Pair> missed;    // touching pairs that it does not, ascending
};

/// O(n log n): the touching pairs come from measure/pairs.h, not from the grid under test.
NeighbourReport neighbour_report(const GridView& view);

/// The same for brute force, which tests every pair and misses none.
NeighbourReport brute_force_report(std::span<const vec4> positions);

uvec3 cell_of_id(const Grid& grid, std::uint32_t cell_id);

/// The cells that collide looks through for a ball in this cell, itself included, in its order; fewer than 27 at
/// the box's sides.
std::vector<std::uint32_t> cells_around(const Grid& grid, std::uint32_t cell_id);

/// One ball's way through the buffers: ball -> cell -> slot -> neighbours.
struct BallTrace {
    std::uint32_t ball = 0;
    std::uint32_t cell_id = 0;
    std::uint32_t slot = 0;
    CellRange range{};                   // slots of its own cell
    std::vector<std::uint32_t> cells;    // cells_around
    std::vector<std::uint32_t> tested;   // balls, in the order in which collide meets them
    std::vector<std::uint32_t> touched;  // of those, the ones that touch
};

/// `ball` must be one of the keys'.
BallTrace trace_ball(const GridView& view, std::uint32_t ball);

}  // namespace ballpit::measure
