// Slots that a GPU fills in an order of its own: which of several threads comes first is nobody's promise. What is in
// them is right in any of many orders, so they are compared in one order, the mirror's.
#pragma once

#include <cstdint>
#include <span>

#include "core/backend.h"
#include "core/layout.h"

namespace ballpit::measure {

/// Whether that is so of a slot: tickets, scattered keys and their origins.
bool any_order(Slot slot);

/// The bytes of such a slot in one order. Tickets: within each cell ascending with the ball id. keys: of the
/// balls, in the order of ball ids.
Bytes tickets_in_order(std::span<const std::byte> tickets, std::span<const Key> keys);
/// Scattered keys: within the slots of each cell ascending.
Bytes scattered_in_order(std::span<const std::byte> scattered_keys, std::span<const CellRange> cell_ranges);
/// Origins: the same.
Bytes origins_in_order(std::span<const std::byte> origins, std::span<const CellRange> cell_ranges);

}  // namespace ballpit::measure
