// One ball's way through the buffers as far as the substep has got, and what each ball carries as a number to be
// coloured by.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/grid.h"
#include "core/layout.h"
#include "core/vector.h"
#include "measure/pairs.h"

namespace ballpit::measure {

/// Copies of the buffers of one substep. What none of its dispatches has written yet is empty.
struct BufferSample {
    std::vector<vec4> positions;  // as the stages read them
    std::vector<vec4> velocities;
    std::vector<Key> keys;               // once assign_cells has run; in whatever order the sort has brought them to
    std::vector<CellRange> cell_ranges;  // once build_grid has run
    std::vector<vec4> next_positions;    // once collide has run
    std::vector<vec4> next_velocities;
    Grid grid;
    bool uses_grid = true;  // false: brute force

    /// Where the balls are drawn.
    const std::vector<vec4>& shown() const { return next_positions.empty() ? positions : next_positions; }
};

/// A ball that collide tests against the one that is followed.
struct NeighbourRow {
    std::uint32_t ball = 0;
    std::optional<std::uint32_t> cell_id;
    std::optional<std::uint32_t> slot;
    float distance = 0.0f;  // m, of the centres
    float overlap = 0.0f;   // m; negative: apart
    bool touches = false;
};

struct BallProbe {
    std::uint32_t ball = 0;
    vec4 position{0.0f};
    vec4 velocity{0.0f};
    std::optional<std::uint32_t> cell_id;
    std::optional<std::uint32_t> slot;
    std::vector<std::uint32_t> cells;  // looked through, in collide's order; none without a grid
    std::vector<CellRange> runs;       // slots of those cells, joined where one begins at the other's end
    std::uint64_t tested = 0;          // balls
    std::uint64_t touched = 0;
    std::vector<NeighbourRow> rows;       // those tested, in collide's order; of brute force only those that touch
    std::optional<vec3> velocity_change;  // m/s, in this substep
    // In quarantine: the first one after this ball, from the start again after the last; itself, where it is the only
    // one.
    std::optional<std::uint32_t> next_quarantined;
};

/// `ball` must be one of the sample's. Ranges and keys are not trusted: whatever points nowhere is left out.
BallProbe probe_ball(const BufferSample& sample, std::uint32_t ball);

/// The balls of a cell, in the order of their slots; none before build_grid has run.
std::vector<std::uint32_t> balls_of_cell(const BufferSample& sample, std::uint32_t cell_id);

/// m by which two balls overlap; negative: the gap.
float overlap_of(const vec4& a, const vec4& b);

/// Touching pairs that collide tests too, and those that the grid hides from it. Everything is found where there is
/// no grid or its ranges are not there yet.
struct FoundPairs {
    std::vector<Pair> found;
    std::vector<Pair> missed;
    std::uint64_t tested = 0;  // ordered pairs
};
FoundPairs found_pairs(const BufferSample& sample);

/// One number a ball; NaN where there is none.
std::vector<float> slot_values(const BufferSample& sample);
std::vector<float> contact_values(const FoundPairs& pairs, std::size_t balls);
std::vector<float> radius_values(const BufferSample& sample);
/// Lengths of the differences of the first three components.
std::vector<float> difference_values(std::span<const vec4> a, std::span<const vec4> b);

}  // namespace ballpit::measure
