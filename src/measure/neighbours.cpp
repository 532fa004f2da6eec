#include "measure/neighbours.h"

#include <algorithm>
#include <cassert>

namespace ballpit::measure {

namespace {

// Cell id of each ball, from the keys.
std::vector<std::uint32_t> cells_of_balls(const GridView& view) {
    std::vector<std::uint32_t> cells(view.positions.size(), 0);
    for (const Key& key : view.keys) {
        if (key.ball_id < cells.size()) {
            cells[key.ball_id] = key.cell_id;
        }
    }
    return cells;
}

bool are_neighbours(const Grid& grid, std::uint32_t a, std::uint32_t b) {
    const glm::ivec3 apart = glm::abs(glm::ivec3(cell_of_id(grid, a)) - glm::ivec3(cell_of_id(grid, b)));
    return apart.x <= 1 && apart.y <= 1 && apart.z <= 1;
}

}  // namespace

uvec3 cell_of_id(const Grid& grid, std::uint32_t cell_id) {
    return {cell_id % grid.cells.x, cell_id / grid.cells.x % grid.cells.y, cell_id / grid.cells.x / grid.cells.y};
}

std::vector<std::uint32_t> cells_around(const Grid& grid, std::uint32_t cell_id) {
    const uvec3 middle = cell_of_id(grid, cell_id);
    const uvec3 low = middle - glm::min(middle, uvec3(1));
    const uvec3 high = glm::min(middle + 1u, grid.cells - 1u);
    std::vector<std::uint32_t> cells;
    for (std::uint32_t z = low.z; z <= high.z; ++z) {
        for (std::uint32_t y = low.y; y <= high.y; ++y) {
            for (std::uint32_t x = low.x; x <= high.x; ++x) {
                cells.push_back((z * grid.cells.y + y) * grid.cells.x + x);
            }
        }
    }
    return cells;
}

NeighbourReport neighbour_report(const GridView& view) {
    NeighbourReport report;
    const std::vector<std::uint32_t> cells = cells_of_balls(view);
    for (std::uint32_t cell = 0; cell < view.cell_ranges.size(); ++cell) {
        const std::uint64_t here = view.cell_ranges[cell].end - view.cell_ranges[cell].first;
        if (here == 0) {
            continue;
        }
        std::uint64_t around = 0;
        for (const std::uint32_t other : cells_around(view.grid, cell)) {
            around += view.cell_ranges[other].end - view.cell_ranges[other].first;
        }
        report.tested += here * (around - 1);  // not itself
    }
    for (const Pair& pair : touching_pairs(view.positions)) {
        if (are_neighbours(view.grid, cells[pair.a], cells[pair.b])) {
            ++report.contacts;
        } else {
            report.missed.push_back(pair);
        }
    }
    return report;
}

NeighbourReport brute_force_report(std::span<const vec4> positions) {
    const std::uint64_t n = positions.size();
    return {n == 0 ? 0 : n * (n - 1), static_cast<std::uint32_t>(touching_pairs(positions).size()), {}};
}

BallTrace trace_ball(const GridView& view, std::uint32_t ball) {
    const auto key = std::ranges::find(view.keys, ball, &Key::ball_id);
    assert(key != view.keys.end());
    BallTrace trace;
    trace.ball = ball;
    trace.cell_id = key->cell_id;
    trace.slot = static_cast<std::uint32_t>(key - view.keys.begin());
    trace.range = view.cell_ranges[trace.cell_id];
    trace.cells = cells_around(view.grid, trace.cell_id);
    for (const std::uint32_t cell : trace.cells) {
        for (std::uint32_t slot = view.cell_ranges[cell].first; slot < view.cell_ranges[cell].end; ++slot) {
            const std::uint32_t other = view.keys[slot].ball_id;
            if (other != ball) {
                trace.tested.push_back(other);
            }
        }
    }
    std::ranges::copy_if(trace.tested, std::back_inserter(trace.touched),
                         [&](std::uint32_t other) { return touching(view.positions[ball], view.positions[other]); });
    return trace;
}

}  // namespace ballpit::measure
