#include "measure/ball_probe.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/quarantine.h"
#include "measure/neighbours.h"

namespace ballpit::measure {

namespace {

constexpr float no_value = std::numeric_limits<float>::quiet_NaN();

NeighbourRow row_of(const BufferSample& sample, std::uint32_t ball, std::uint32_t other) {
    const vec4& a = sample.positions[ball];
    const vec4& b = sample.positions[other];
    NeighbourRow row;
    row.ball = other;
    row.distance = glm::distance(vec3(a), vec3(b));
    row.overlap = overlap_of(a, b);
    row.touches = touching(a, b);
    return row;
}

void add_row(BallProbe& probe, const NeighbourRow& row, bool keep) {
    ++probe.tested;
    probe.touched += row.touches ? 1 : 0;
    if (keep) {
        probe.rows.push_back(row);
    }
}

void ask_everyone(const BufferSample& sample, BallProbe& probe) {
    for (std::uint32_t other = 0; other < sample.positions.size(); ++other) {
        if (other != probe.ball) {
            const NeighbourRow row = row_of(sample, probe.ball, other);
            add_row(probe, row, row.touches);
        }
    }
}

CellRange checked_range(const BufferSample& sample, std::uint32_t cell) {
    if (cell >= sample.cell_ranges.size()) {
        return {0, 0};
    }
    const CellRange& range = sample.cell_ranges[cell];
    const auto end = std::min(range.end, static_cast<std::uint32_t>(sample.keys.size()));
    return {std::min(range.first, end), end};
}

void look_through_cells(const BufferSample& sample, BallProbe& probe) {
    probe.cells = cells_around(sample.grid, *probe.cell_id);
    for (const std::uint32_t cell : probe.cells) {
        const CellRange range = checked_range(sample, cell);
        if (range.first == range.end) {
            continue;
        }
        if (!probe.runs.empty() && probe.runs.back().end == range.first) {
            probe.runs.back().end = range.end;
        } else {
            probe.runs.push_back(range);
        }
        for (std::uint32_t slot = range.first; slot < range.end; ++slot) {
            const std::uint32_t other = sample.keys[slot].ball_id;
            if (other != probe.ball && other < sample.positions.size()) {
                NeighbourRow row = row_of(sample, probe.ball, other);
                row.cell_id = cell;
                row.slot = slot;
                add_row(probe, row, true);
            }
        }
    }
}

// Cell id of each ball, from the keys.
std::vector<std::uint32_t> cells_of_balls(const BufferSample& sample) {
    std::vector<std::uint32_t> cells(sample.positions.size(), 0);
    for (const Key& key : sample.keys) {
        if (key.ball_id < cells.size() && key.cell_id < sample.cell_ranges.size()) {
            cells[key.ball_id] = key.cell_id;
        }
    }
    return cells;
}

bool next_to_each_other(const Grid& grid, std::uint32_t a, std::uint32_t b) {
    const glm::ivec3 apart = glm::abs(glm::ivec3(cell_of_id(grid, a)) - glm::ivec3(cell_of_id(grid, b)));
    return apart.x <= 1 && apart.y <= 1 && apart.z <= 1;
}

std::uint64_t pairs_tested(const BufferSample& sample) {
    std::uint64_t tested = 0;
    for (std::uint32_t cell = 0; cell < sample.cell_ranges.size(); ++cell) {
        const CellRange range = checked_range(sample, cell);
        const std::uint64_t here = range.end - range.first;
        if (here == 0) {
            continue;
        }
        std::uint64_t around = 0;
        for (const std::uint32_t other : cells_around(sample.grid, cell)) {
            const CellRange other_range = checked_range(sample, other);
            around += other_range.end - other_range.first;
        }
        tested += here * (around - 1);
    }
    return tested;
}

}  // namespace

namespace {

std::optional<std::uint32_t> quarantined_after(const std::vector<vec4>& positions, std::uint32_t ball) {
    const auto count = static_cast<std::uint32_t>(positions.size());
    for (std::uint32_t i = 1; i <= count; ++i) {
        const std::uint32_t other = (ball + i) % count;
        if (in_quarantine(positions[other])) {
            return other;
        }
    }
    return std::nullopt;
}

}  // namespace

BallProbe probe_ball(const BufferSample& sample, std::uint32_t ball) {
    assert(ball < sample.positions.size());
    BallProbe probe;
    probe.ball = ball;
    probe.position = sample.positions[ball];
    probe.next_quarantined = quarantined_after(sample.positions, ball);
    if (ball < sample.velocities.size()) {
        probe.velocity = sample.velocities[ball];
    }
    if (ball < sample.next_velocities.size()) {
        probe.velocity_change = vec3(sample.next_velocities[ball]) - vec3(probe.velocity);
    }
    if (!sample.uses_grid) {
        ask_everyone(sample, probe);
        return probe;
    }
    const auto key = std::ranges::find(sample.keys, ball, &Key::ball_id);
    if (key == sample.keys.end()) {
        return probe;
    }
    probe.cell_id = key->cell_id;
    probe.slot = static_cast<std::uint32_t>(key - sample.keys.begin());
    if (!sample.cell_ranges.empty() && key->cell_id < sample.cell_ranges.size()) {
        look_through_cells(sample, probe);
    }
    return probe;
}

std::vector<std::uint32_t> balls_of_cell(const BufferSample& sample, std::uint32_t cell_id) {
    std::vector<std::uint32_t> balls;
    const CellRange range = checked_range(sample, cell_id);
    for (std::uint32_t slot = range.first; slot < range.end; ++slot) {
        balls.push_back(sample.keys[slot].ball_id);
    }
    return balls;
}

float overlap_of(const vec4& a, const vec4& b) { return a.w + b.w - glm::distance(vec3(a), vec3(b)); }

FoundPairs found_pairs(const BufferSample& sample) {
    FoundPairs pairs;
    pairs.found = touching_pairs(sample.positions);
    const std::uint64_t n = sample.positions.size();
    if (!sample.uses_grid) {
        pairs.tested = n == 0 ? 0 : n * (n - 1);
        return pairs;
    }
    if (sample.cell_ranges.empty()) {
        return pairs;
    }
    pairs.tested = pairs_tested(sample);
    const std::vector<std::uint32_t> cells = cells_of_balls(sample);
    const auto hidden = std::stable_partition(pairs.found.begin(), pairs.found.end(), [&](const Pair& p) {
        return next_to_each_other(sample.grid, cells[p.a], cells[p.b]);
    });
    pairs.missed.assign(hidden, pairs.found.end());
    pairs.found.erase(hidden, pairs.found.end());
    return pairs;
}

std::vector<float> slot_values(const BufferSample& sample) {
    std::vector<float> values(sample.positions.size(), no_value);
    for (std::size_t slot = 0; slot < sample.keys.size(); ++slot) {
        if (sample.keys[slot].ball_id < values.size()) {
            values[sample.keys[slot].ball_id] = static_cast<float>(slot);
        }
    }
    return values;
}

std::vector<float> contact_values(const FoundPairs& pairs, std::size_t balls) {
    std::vector<float> values(balls, 0.0f);
    for (const Pair& pair : pairs.found) {
        values[pair.a] += 1.0f;
        values[pair.b] += 1.0f;
    }
    return values;
}

std::vector<float> radius_values(const BufferSample& sample) {
    std::vector<float> values(sample.positions.size());
    std::ranges::transform(sample.positions, values.begin(), [](const vec4& position) { return std::abs(position.w); });
    return values;
}

std::vector<float> difference_values(std::span<const vec4> a, std::span<const vec4> b) {
    assert(a.size() == b.size());
    std::vector<float> values(a.size());
    std::ranges::transform(a, b, values.begin(),
                           [](const vec4& x, const vec4& y) { return glm::distance(vec3(x), vec3(y)); });
    return values;
}

}  // namespace ballpit::measure
