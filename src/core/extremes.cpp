#include "core/extremes.h"

#include <algorithm>
#include <cstdio>

namespace ballpit {

namespace {

constexpr std::array<ExtremeInfo, extreme_count> table = {{
    {Extreme::quarantined, "quarantined", "In quarantine", "balls", true,
     "collide: position or velocity became no number, or too large. The ball rests where it was last and touches "
     "nobody. More substeps, a shorter step or less stiffness help; then restart."},
    {Extreme::out_of_bounds, "out_of_bounds", "Outside the box", "times", true,
     "assign_cells: a ball's centre lies beyond the walls; it counts as in the nearest cell. Stiffer walls, or fewer "
     "balls."},
    {Extreme::over_capacity, "over_capacity", "No room", "times", true,
     "build_grid: a key names a cell or ball that has no room; its contacts are missing."},
    {Extreme::missed_contacts, "missed_contacts", "Missed contacts", "times", true,
     "count_missed: a ball would not have found one that it touches, because the grid was too old. A wider cell factor "
     "or less reuse helps."},
    {Extreme::too_fast, "too_fast", "Too fast", "times", true,
     "collide: a ball moves by more than its radius in a substep and may miss what is in its way. More substeps."},
    {Extreme::coincident, "coincident", "Same centre", "times", true,
     "collide: two balls have the same centre; they part along an axis that follows from their numbers."},
    {Extreme::capped_walls, "capped_walls", "Deep in a wall", "times", true,
     "collide: a ball is so far beyond a wall that the wall's push grows no more; it comes back slowly."},
    {Extreme::hitches, "hitches", "Hitches", "frames", true,
     "A frame came so late that its time is dropped: slow motion for a moment, never a longer step."},
    {Extreme::ball_larger_than_box, "ball_larger_than_box", "Ball against box", "of its width", false,
     "The largest ball is wider than the box: two walls hold it from both sides. A wider box, or smaller balls."},
    {Extreme::float_floor, "float_floor", "Float floor", "of the sag", false,
     "A step of the floats at the walls, against the overlap of a ball at rest, m g / k: beyond 0.01 balls at rest "
     "tremble. A smaller box, less stiffness, or compensated sums."},
    {Extreme::tiny_dt, "tiny_dt", "Tiny step", "of the speed", false,
     "Rounding of positions takes this share of a ball's way in a substep. Fewer substeps, or compensated sums."},
    {Extreme::unstable_dt, "unstable_dt", "Unstable step", "of the limit", false,
     "A substep is longer than the springs allow: piles blow up. More substeps, less stiffness, or heavier balls."},
    {Extreme::few_substeps_per_contact, "few_substeps_per_contact", "Coarse contact", "substeps", false,
     "The shortest contact lasts no more substeps than this: balls bounce back at a wrong speed. More substeps."},
    {Extreme::explicit_dashpot_limit, "explicit_dashpot_limit", "Strong dashpot", "of the limit", false,
     "A substep is longer than an explicit dashpot allows. More substeps, or the dashpot semi_implicit."},
    {Extreme::numerical_heating, "numerical_heating", "Heating", "N s/m", false,
     "The integrator pushes balls apart by so much more than their dashpot holds: nothing ever comes to rest. Leapfrog "
     "does not."},
    {Extreme::cell_too_small, "cell_too_small", "Narrow cells", "of 2 r", false,
     "Cells are narrower than the largest ball and miss contacts: there to be shown. Cell factor 1."},
    {Extreme::initial_overlap, "initial_overlap", "Stored in overlaps", "J", false,
     "Balls overlap deeply at the start, and this energy will drive them apart. Relax pushes them apart first."},
}};

constexpr bool in_order() {
    for (std::size_t i = 0; i < table.size(); ++i) {
        if (static_cast<std::size_t>(table[i].extreme) != i) {
            return false;
        }
    }
    return true;
}
static_assert(in_order());

// A sum may have run over; then its bit is what is left of it.
double counted(const Status& status, std::uint32_t bit, std::uint32_t sum) {
    return static_cast<double>((status.bits & bit) != 0 ? std::max(sum, 1u) : sum);
}

}  // namespace

std::span<const ExtremeInfo, extreme_count> extreme_table() { return table; }

ExtremeNumbers counted_extremes(const Status& status) {
    ExtremeNumbers numbers;
    numbers[Extreme::quarantined] = counted(status, STATUS_NOT_FINITE, status.not_finite);
    numbers[Extreme::out_of_bounds] = counted(status, STATUS_OUT_OF_BOUNDS, status.out_of_bounds);
    numbers[Extreme::over_capacity] = counted(status, STATUS_OVER_CAPACITY, status.over_capacity);
    numbers[Extreme::missed_contacts] = counted(status, STATUS_MISSED, status.missed);
    numbers[Extreme::too_fast] = counted(status, STATUS_TOO_FAST, status.too_fast);
    numbers[Extreme::coincident] = counted(status, STATUS_COINCIDENT, status.coincident);
    numbers[Extreme::capped_walls] = counted(status, STATUS_CAPPED_WALL, status.capped_walls);
    return numbers;
}

std::string extreme_text(const ExtremeInfo& info, double number) {
    std::array<char, 32> digits{};
    std::snprintf(digits.data(), digits.size(), info.counted ? "%.0f" : "%.3g", number);
    return std::string(info.label) + ": " + digits.data() + (info.unit.empty() ? "" : " " + std::string(info.unit)) +
           ". " + std::string(info.about);
}

}  // namespace ballpit
