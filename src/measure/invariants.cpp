#include "measure/invariants.h"

#include <cmath>
#include <vector>

namespace ballpit::measure {

namespace {

std::string key_text(const Key& key) {
    return "(cell " + std::to_string(key.cell_id) + ", ball " + std::to_string(key.ball_id) + ")";
}

bool finite(const vec4& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

}  // namespace

Violation keys_assigned(std::span<const Key> keys, std::uint32_t ball_count, std::uint32_t cell_count) {
    for (std::uint32_t i = 0; i < keys.size(); ++i) {
        if (i >= ball_count && !(keys[i] == Key{SENTINEL, SENTINEL})) {
            return "key " + std::to_string(i) + " pads and should be a sentinel, is " + key_text(keys[i]);
        }
        if (i < ball_count && (keys[i].ball_id != i || keys[i].cell_id >= cell_count)) {
            return "key " + std::to_string(i) + " should name ball " + std::to_string(i) + " and a cell below " +
                   std::to_string(cell_count) + ", is " + key_text(keys[i]);
        }
    }
    return std::nullopt;
}

Violation keys_sorted(std::span<const Key> keys, std::uint32_t ball_count) {
    if (keys.size() < ball_count) {
        return std::to_string(keys.size()) + " keys for " + std::to_string(ball_count) + " balls";
    }
    std::vector<bool> seen(ball_count, false);
    for (std::uint32_t slot = 0; slot < keys.size(); ++slot) {
        const Key& key = keys[slot];
        if (slot > 0 && key < keys[slot - 1]) {
            return "slot " + std::to_string(slot) + " holds " + key_text(key) + ", which sorts before slot " +
                   std::to_string(slot - 1) + "'s " + key_text(keys[slot - 1]);
        }
        if (slot >= ball_count) {
            if (!(key == Key{SENTINEL, SENTINEL})) {
                return "slot " + std::to_string(slot) + " should hold a sentinel, holds " + key_text(key);
            }
            continue;
        }
        if (key.ball_id >= ball_count || seen[key.ball_id]) {
            return "slot " + std::to_string(slot) + " holds ball " + std::to_string(key.ball_id) +
                   (key.ball_id >= ball_count ? ", which does not exist" : " a second time");
        }
        seen[key.ball_id] = true;
    }
    return std::nullopt;
}

Violation ranges_partition(std::span<const CellRange> cell_ranges, std::span<const Key> keys,
                           std::uint32_t ball_count) {
    // Sorted by cell id, the ranges of the occupied cells follow one another without gap or overlap.
    std::uint32_t next = 0;
    for (std::uint32_t cell = 0; cell < cell_ranges.size(); ++cell) {
        const CellRange& range = cell_ranges[cell];
        if (range == CellRange{0, 0}) {
            continue;
        }
        const std::string text = "cell " + std::to_string(cell) + " has slots [" + std::to_string(range.first) + ", " +
                                 std::to_string(range.end) + ")";
        if (range.first != next || range.end <= range.first || range.end > ball_count || range.end > keys.size()) {
            return text + ", expected to start at " + std::to_string(next) + " and to end by " +
                   std::to_string(ball_count);
        }
        for (std::uint32_t slot = range.first; slot < range.end; ++slot) {
            if (keys[slot].cell_id != cell) {
                return text + ", but slot " + std::to_string(slot) + " holds " + key_text(keys[slot]);
            }
        }
        next = range.end;
    }
    if (next != ball_count) {
        return "the ranges end at slot " + std::to_string(next) + " of " + std::to_string(ball_count);
    }
    return std::nullopt;
}

Violation all_finite(std::span<const vec4> positions, std::span<const vec4> velocities) {
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (!finite(positions[i]) || !finite(velocities[i])) {
            return "ball " + std::to_string(i) + " has a position or velocity that is not finite";
        }
    }
    return std::nullopt;
}

}  // namespace ballpit::measure
