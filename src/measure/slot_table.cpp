#include "measure/slot_table.h"

#include <array>
#include <bit>
#include <cassert>
#include <charconv>
#include <cstring>

#include "core/layout.h"

namespace ballpit::measure {

namespace {

constexpr std::array<SlotColumn, 4> position_columns = {
    {{"x", "m", true}, {"y", "m", true}, {"z", "m", true}, {"radius", "m", true}}};
constexpr std::array<SlotColumn, 4> velocity_columns = {
    {{"vx", "m/s", true}, {"vy", "m/s", true}, {"vz", "m/s", true}, {"mass", "kg", true}}};
constexpr std::array<SlotColumn, 1> damping_columns = {{{"damping_ratio", "", true}}};
constexpr std::array<SlotColumn, 2> key_columns = {{{"cell_id", "", false}, {"ball_id", "", false}}};
constexpr std::array<SlotColumn, 1> used_columns = {{{"used", "", false}}};
constexpr std::array<SlotColumn, 1> ticket_columns = {{{"ticket", "", false}}};
constexpr std::array<SlotColumn, 1> origin_columns = {{{"place", "", false}}};
constexpr std::array<SlotColumn, 1> count_columns = {{{"balls", "", false}}};
constexpr std::array<SlotColumn, 2> range_columns = {{{"first", "", false}, {"end", "", false}}};
constexpr std::array<SlotColumn, 6> compensation_columns = {{{"x", "m", true},
                                                             {"y", "m", true},
                                                             {"z", "m", true},
                                                             {"vx", "m/s", true},
                                                             {"vy", "m/s", true},
                                                             {"vz", "m/s", true}}};
constexpr std::array<SlotColumn, 10> status_columns = {{{"bits", "", false},
                                                        {"not_finite", "", false},
                                                        {"out_of_bounds", "", false},
                                                        {"over_capacity", "", false},
                                                        {"missed", "", false},
                                                        {"drift_bits", "", false},
                                                        {"too_fast", "", false},
                                                        {"coincident", "", false},
                                                        {"capped_walls", "", false},
                                                        {"quarantined_ball", "", false}}};

std::uint32_t word_at(std::span<const std::byte> bytes, std::size_t word) {
    std::uint32_t value = 0;
    assert((word + 1) * sizeof(value) <= bytes.size());
    std::memcpy(&value, bytes.data() + word * sizeof(value), sizeof(value));
    return value;
}

}  // namespace

std::span<const SlotColumn> slot_columns(Slot slot) {
    switch (slot) {
        case Slot::positions:
        case Slot::next_positions:
        case Slot::built_positions:
        case Slot::sorted_positions:
            return position_columns;
        case Slot::velocities:
        case Slot::next_velocities:
        case Slot::sorted_velocities:
            return velocity_columns;
        case Slot::damping_ratios:
            return damping_columns;
        case Slot::keys:
        case Slot::scattered_keys:
            return key_columns;
        case Slot::used_tiles:
            return used_columns;
        case Slot::tickets:
            return ticket_columns;
        case Slot::tile_counts:
            return count_columns;
        case Slot::origins:
            return origin_columns;
        case Slot::cell_ranges:
            return range_columns;
        case Slot::compensations:
            return compensation_columns;
        case Slot::status:
            break;
    }
    return status_columns;
}

std::string_view slot_element(Slot slot) {
    switch (slot) {
        case Slot::keys:
        case Slot::scattered_keys:
        case Slot::sorted_positions:
        case Slot::sorted_velocities:
        case Slot::origins:
            return "slot";
        case Slot::used_tiles:
        case Slot::tile_counts:
            return "tile";
        case Slot::cell_ranges:
            return "cell";
        case Slot::status:
            return "status";
        default:
            return "ball";
    }
}

std::size_t element_count(Slot slot, std::span<const std::byte> bytes) {
    return bytes.size() / (slot_columns(slot).size() * sizeof(std::uint32_t));
}

std::string element_text(Slot slot, std::span<const std::byte> bytes, std::size_t element, std::size_t column) {
    const auto columns = slot_columns(slot);
    const std::uint32_t word = word_at(bytes, element * columns.size() + column);
    if (!columns[column].is_float) {
        return std::to_string(word);
    }
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), std::bit_cast<float>(word)).ptr;
    return {text.data(), end};
}

std::optional<std::size_t> element_of_ball(Slot slot, std::span<const std::byte> bytes, std::uint32_t ball) {
    const std::size_t count = element_count(slot, bytes);
    if (slot_element(slot) == "ball") {
        return ball < count ? std::optional<std::size_t>(ball) : std::nullopt;
    }
    for (std::size_t i = 0; slot == Slot::keys && i < count; ++i) {
        if (word_at(bytes, 2 * i + 1) == ball && word_at(bytes, 2 * i) != SENTINEL) {
            return i;
        }
    }
    return std::nullopt;
}

void write_slot_csv(std::ostream& out, Slot slot, std::span<const std::byte> bytes) {
    const auto columns = slot_columns(slot);
    out << slot_element(slot);
    for (const SlotColumn& column : columns) {
        out << ',' << column.name;
    }
    out << '\n';
    for (std::size_t i = 0; i < element_count(slot, bytes); ++i) {
        out << i;
        for (std::size_t column = 0; column < columns.size(); ++column) {
            out << ',' << element_text(slot, bytes, i, column);
        }
        out << '\n';
    }
}

}  // namespace ballpit::measure
