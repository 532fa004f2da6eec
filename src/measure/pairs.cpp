#include "measure/pairs.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/quarantine.h"

namespace ballpit::measure {

namespace {

using Cell = std::array<std::int64_t, 3>;

struct Entry {
    Cell cell;
    std::uint32_t ball;
    auto operator<=>(const Entry&) const = default;
};

// Far-away coordinates are clamped: that keeps the order of cells, so neighbours stay neighbours.
std::int64_t cell_along(float coordinate, double width) {
    constexpr double farthest = 1e15;
    return static_cast<std::int64_t>(
        std::clamp(std::floor(static_cast<double>(coordinate) / width), -farthest, farthest));
}

std::vector<Entry> sorted_entries(std::span<const vec4> positions) {
    float r_max = 0.0f;
    for (const vec4& p : positions) {
        r_max = std::max(r_max, p.w);
    }
    // A little wider than the diameter: the quotient of two rounded numbers must not cost a pair.
    const double width = std::max(2.0 * static_cast<double>(r_max), 1e-12) * (1.0 + 1e-6);
    std::vector<Entry> entries;
    for (std::uint32_t i = 0; i < positions.size(); ++i) {
        const vec4& p = positions[i];
        if (!std::isnan(p.x) && !std::isnan(p.y) && !std::isnan(p.z)) {
            entries.push_back({{cell_along(p.x, width), cell_along(p.y, width), cell_along(p.z, width)}, i});
        }
    }
    std::ranges::sort(entries);
    return entries;
}

}  // namespace

bool touching(const vec4& a, const vec4& b) {
    const float x = a.x - b.x;
    const float y = a.y - b.y;
    const float z = a.z - b.z;
    const float reach = a.w + b.w;
    return x * x + y * y + z * z < reach * reach && !in_quarantine(a) && !in_quarantine(b);
}

std::vector<Pair> brute_force_pairs(std::span<const vec4> positions) {
    std::vector<Pair> pairs;
    for (std::uint32_t a = 0; a < positions.size(); ++a) {
        for (std::uint32_t b = a + 1; b < positions.size(); ++b) {
            if (touching(positions[a], positions[b])) {
                pairs.push_back({a, b});
            }
        }
    }
    return pairs;
}

std::vector<Pair> touching_pairs(std::span<const vec4> positions) {
    const std::vector<Entry> entries = sorted_entries(positions);
    std::vector<Pair> pairs;
    for (const Entry& entry : entries) {
        for (std::int64_t dx = -1; dx <= 1; ++dx) {
            for (std::int64_t dy = -1; dy <= 1; ++dy) {
                // The three cells along the last axis are neighbours in the order.
                const Cell first{entry.cell[0] + dx, entry.cell[1] + dy, entry.cell[2] - 1};
                const Cell last{first[0], first[1], entry.cell[2] + 1};
                auto other = std::ranges::lower_bound(entries, first, {}, &Entry::cell);
                for (; other != entries.end() && other->cell <= last; ++other) {
                    if (entry.ball < other->ball && touching(positions[entry.ball], positions[other->ball])) {
                        pairs.push_back({entry.ball, other->ball});
                    }
                }
            }
        }
    }
    std::ranges::sort(pairs);
    return pairs;
}

}  // namespace ballpit::measure
