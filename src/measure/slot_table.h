// A slot's bytes as a table: columns with names and units, cells as text, CSV.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <string_view>

#include "core/schedule.h"

namespace ballpit::measure {

struct SlotColumn {
    std::string_view name;
    std::string_view unit;  // "" where there is none
    bool is_float;
};

/// Columns of the slot's elements, one a 32-bit word.
std::span<const SlotColumn> slot_columns(Slot slot);

/// What one element is called: ball, slot, cell, status.
std::string_view slot_element(Slot slot);

/// Elements that a slot's bytes hold.
std::size_t element_count(Slot slot, std::span<const std::byte> bytes);

/// Shortest text that reads back as the same number.
std::string element_text(Slot slot, std::span<const std::byte> bytes, std::size_t element, std::size_t column);

/// The element that speaks of a ball: itself in the buffers of balls, its slot in the keys; none elsewhere.
std::optional<std::size_t> element_of_ball(Slot slot, std::span<const std::byte> bytes, std::uint32_t ball);

/// Header with the element's name and the columns, then one row an element.
void write_slot_csv(std::ostream& out, Slot slot, std::span<const std::byte> bytes);

}  // namespace ballpit::measure
