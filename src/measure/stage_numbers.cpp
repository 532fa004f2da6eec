#include "measure/stage_numbers.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "measure/pairs.h"
#include "measure/sort_pass.h"

namespace ballpit::measure {

AssignNumbers assign_numbers(const Schedule& schedule, std::span<const Key> keys, std::span<const vec4> positions,
                             const Box& box) {
    AssignNumbers numbers;
    numbers.balls = schedule.ball_count;
    numbers.cells = schedule.cell_count;
    std::vector<std::uint32_t> cells;
    cells.reserve(keys.size());
    for (const Key& key : keys) {
        if (key.cell_id == SENTINEL) {
            ++numbers.padding;
        } else {
            cells.push_back(key.cell_id);
        }
    }
    std::ranges::sort(cells);
    numbers.occupied = static_cast<std::uint32_t>(std::unique(cells.begin(), cells.end()) - cells.begin());
    const vec3 lower(box.lower);
    const vec3 upper(box.upper);
    numbers.outside = static_cast<std::uint32_t>(std::ranges::count_if(positions, [&](const vec4& p) {
        return !(glm::all(glm::greaterThanEqual(vec3(p), lower)) && glm::all(glm::lessThanEqual(vec3(p), upper)));
    }));
    return numbers;
}

SortNumbers sort_numbers(const Schedule& schedule, const Dispatch& pass, std::span<const Key> before) {
    SortNumbers numbers;
    numbers.k = pass.constants[0];
    numbers.j = pass.constants[1];
    numbers.pass = pass_number(numbers.k, numbers.j);
    numbers.passes = pass_count(schedule.key_count);
    numbers.pairs = schedule.key_count / 2;
    if (before.size() == schedule.key_count) {
        numbers.swapped = count_swaps(numbers.k, numbers.j, before);
    }
    return numbers;
}

BuildNumbers build_numbers(std::span<const CellRange> cell_ranges) {
    BuildNumbers numbers;
    numbers.cells = static_cast<std::uint32_t>(cell_ranges.size());
    for (std::uint32_t cell = 0; cell < numbers.cells; ++cell) {
        const CellRange& range = cell_ranges[cell];
        const std::uint32_t balls = range.end > range.first ? range.end - range.first : 0;
        numbers.occupied += balls > 0 ? 1 : 0;
        if (balls > numbers.most) {
            numbers.most = balls;
            numbers.fullest = cell;
        }
    }
    return numbers;
}

CollideNumbers collide_numbers(std::span<const vec4> positions, std::span<const vec4> new_velocities) {
    CollideNumbers numbers;
    if (positions.size() <= most_balls_for_contacts) {
        const std::vector<Pair> pairs = touching_pairs(positions);
        numbers.contacts = static_cast<std::uint32_t>(pairs.size());
        for (const Pair& pair : pairs) {
            const vec4& a = positions[pair.a];
            const vec4& b = positions[pair.b];
            numbers.largest_overlap = std::max(numbers.largest_overlap, a.w + b.w - glm::distance(vec3(a), vec3(b)));
        }
    }
    for (std::uint32_t ball = 0; ball < new_velocities.size(); ++ball) {
        const float speed = glm::length(vec3(new_velocities[ball]));
        if (!std::isfinite(speed)) {
            ++numbers.not_finite;
        } else if (!numbers.fastest || speed > numbers.top_speed) {
            numbers.fastest = ball;
            numbers.top_speed = speed;
        }
    }
    return numbers;
}

}  // namespace ballpit::measure
