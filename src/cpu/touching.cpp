#include "cpu/touching.h"

#include <algorithm>
#include <array>

namespace ballpit::cpu {

namespace {

struct Slots {
    std::uint32_t first;
    std::uint32_t end;
};

constexpr std::size_t rows_after = 4;  // of cells that come after the one of a ball, and touch it

// The slots of up to three cells side by side, which lie in a row; empty cells know no place.
Slots slots_of(std::span<const CellRange> cells) {
    Slots slots{SENTINEL, 0};
    for (const CellRange& cell : cells) {
        if (cell.end > cell.first) {
            slots = {std::min(slots.first, cell.first), std::max(slots.end, cell.end)};
        }
    }
    return slots.end == 0 ? Slots{0, 0} : slots;
}

// What a ball of one cell may touch beyond its own slot: the rest of its row, and the rows of higher cells.
struct Surroundings {
    std::uint32_t row_end;
    std::array<Slots, rows_after> rows;
};

Surroundings surroundings_of(const SubstepParams<float>& params, std::span<const CellRange> cell_ranges,
                             std::uint32_t cell) {
    const uvec3 cells = params.grid_cells;
    const std::uint32_t x = cell % cells.x;
    const std::uint32_t y = cell / cells.x % cells.y;
    const std::uint32_t z = cell / (cells.x * cells.y);
    const std::uint32_t left = x > 0 ? x - 1 : 0;
    const std::uint32_t right = std::min(x + 1, cells.x - 1);
    const auto row = [&](std::uint32_t from, std::uint32_t y_of_row, std::uint32_t z_of_row) {
        return slots_of(cell_ranges.subspan((z_of_row * cells.y + y_of_row) * cells.x + from, right - from + 1));
    };
    Surroundings around{row(x, y, z).end, {}};
    if (y + 1 < cells.y) {
        around.rows[0] = row(left, y + 1, z);
    }
    if (z + 1 < cells.z) {
        around.rows[1] = y > 0 ? row(left, y - 1, z + 1) : Slots{0, 0};
        around.rows[2] = row(left, y, z + 1);
        around.rows[3] = y + 1 < cells.y ? row(left, y + 1, z + 1) : Slots{0, 0};
    }
    return around;
}

constexpr std::uint32_t lanes = 4;   // candidates side by side: what every processor's vectors hold
constexpr std::uint32_t group = 64;  // candidates at a time

using Hits = std::array<std::uint32_t, group>;

// Whether the balls at `first` and the following slots touch the one at `slot`; in collide's order of operations. In
// whole lanes, so beyond `count` as well.
void look_at(const SortedBalls& balls, std::uint32_t slot, std::uint32_t first, std::uint32_t count, Hits& hits) {
    const float* const x = balls.x.data();
    const float* const y = balls.y.data();
    const float* const z = balls.z.data();
    const float* const radius = balls.radius.data();
    for (std::uint32_t start = 0; start < count; start += lanes) {
        for (std::uint32_t lane = start; lane < start + lanes; ++lane) {
            const float dx = x[slot] - x[first + lane];
            const float dy = y[slot] - y[first + lane];
            const float dz = z[slot] - z[first + lane];
            const float reach = radius[slot] + radius[first + lane];
            hits[lane] = dx * dx + dy * dy + dz * dz < reach * reach ? 1 : 0;
        }
    }
}

// Adds those of `slots` that touch the ball at `slot`. A place is written for every candidate, and kept for those that
// touch: no branch that nobody can foresee.
std::size_t add_touching(const SortedBalls& balls, std::uint32_t slot, Slots slots, std::vector<TouchingPair>& pairs,
                         std::size_t count) {
    Hits hits;
    for (std::uint32_t first = slots.first; first < slots.end; first += group) {
        const std::uint32_t candidates = std::min(group, slots.end - first);
        look_at(balls, slot, first, candidates, hits);
        if (pairs.size() < count + group) {
            pairs.resize(2 * (count + group));
        }
        for (std::uint32_t i = 0; i < candidates; ++i) {
            pairs[count] = {slot, first + i};
            count += hits[i];
        }
    }
    return count;
}

}  // namespace

void SortedBalls::resize(std::size_t count) {
    for (std::vector<float>* values : {&x, &y, &z, &radius}) {
        values->resize(count + lanes - 1);
    }
}

std::size_t find_touching(const SubstepParams<float>& params, std::span<const Key> keys,
                          std::span<const CellRange> cell_ranges, const SortedBalls& balls, std::uint32_t first,
                          std::uint32_t end, std::vector<TouchingPair>& pairs) {
    std::size_t count = 0;
    std::uint32_t cell = SENTINEL;
    Surroundings around{};
    for (std::uint32_t slot = first; slot < end; ++slot) {
        if (keys[slot].cell_id != cell) {
            cell = keys[slot].cell_id;
            around = surroundings_of(params, cell_ranges, cell);
        }
        count = add_touching(balls, slot, {slot + 1, around.row_end}, pairs, count);
        for (const Slots& row : around.rows) {
            count = add_touching(balls, slot, row, pairs, count);
        }
    }
    return count;
}

}  // namespace ballpit::cpu
