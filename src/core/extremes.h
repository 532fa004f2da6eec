// What can go wrong at the extremes, each with a name of its own: what is counted while a scene runs, and what is
// warned of before it does. Window, reports and tests take the names from the one table.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/layout.h"

namespace ballpit {

enum class Extreme : std::uint8_t {
    quarantined,
    out_of_bounds,
    over_capacity,
    missed_contacts,
    too_fast,
    coincident,
    capped_walls,
    hitches,
    ball_larger_than_box,
    float_floor,
    tiny_dt,
    unstable_dt,
    few_substeps_per_contact,
    explicit_dashpot_limit,
    numerical_heating,
    cell_too_small,
    initial_overlap,
};
inline constexpr std::size_t extreme_count = 17;

struct ExtremeInfo {
    Extreme extreme;
    std::string_view key;    // as in reports
    std::string_view label;  // as on the panel, before the number
    std::string_view unit;   // of the number; "" where it is a ratio
    bool counted;            // a count since the start; else a warning with its number
    std::string_view about;  // what happened, and what to do
};

/// Every extreme, in the order of the enumeration.
std::span<const ExtremeInfo, extreme_count> extreme_table();

/// The number of each; 0 where there is nothing to say.
struct ExtremeNumbers {
    std::array<double, extreme_count> numbers{};

    double& operator[](Extreme extreme) { return numbers[static_cast<std::size_t>(extreme)]; }
    double operator[](Extreme extreme) const { return numbers[static_cast<std::size_t>(extreme)]; }
};

/// The counts that the stages keep. Where a sum has run over to 0 its bit says that it is not.
ExtremeNumbers counted_extremes(const Status& status);

/// "Too fast: 12 balls. …"
std::string extreme_text(const ExtremeInfo& info, double number);

}  // namespace ballpit
