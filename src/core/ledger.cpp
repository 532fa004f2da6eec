#include "core/ledger.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "core/hazards.h"
#include "core/vector.h"

namespace ballpit {

namespace {

// Runs a substep in the books; gives the number of barriers before its first dispatch and before the others.
BarrierCount run_in_the_books(const Schedule& schedule, Hazards& hazards) {
    BarrierCount count;
    if (schedule.swaps_copies) {
        hazards.swap_copies();
    }
    for (const Dispatch& dispatch : schedule.dispatches) {
        if (const Uses uses = hazards.before(dispatch); uses != 0) {
            hazards.issued(uses);
            ++(&dispatch == &schedule.dispatches.front() ? count.before : count.within);
        }
        hazards.ran(dispatch);
    }
    if (schedule.swaps_states) {
        hazards.swap_states();
    }
    return count;
}

}  // namespace

std::array<std::size_t, slot_count> bytes_of(const Schedule& schedule) {
    std::array<std::size_t, slot_count> bytes{};
    const auto of = [&bytes](Slot slot) -> std::size_t& { return bytes[static_cast<std::size_t>(slot)]; };
    const std::size_t state = schedule.ball_count * sizeof(vec4);
    of(Slot::positions) = of(Slot::velocities) = state;
    of(Slot::next_positions) = of(Slot::next_velocities) = schedule.in_place ? 0 : state;
    of(Slot::damping_ratios) =
        schedule.features.has(Feature::ball_restitution) ? schedule.ball_count * sizeof(float) : 0;
    of(Slot::compensations) =
        schedule.features.has(Feature::compensated) ? schedule.ball_count * sizeof(Compensation) : 0;
    of(Slot::built_positions) = schedule.keeps_places ? state : 0;
    of(Slot::keys) = schedule.key_count * sizeof(Key);
    of(Slot::cell_ranges) = schedule.cell_count * sizeof(CellRange);
    of(Slot::used_tiles) = tile_count(schedule.cell_count) * sizeof(std::uint32_t);
    if (schedule.features.has(Feature::sorted_copies)) {
        of(Slot::sorted_positions) = of(Slot::sorted_velocities) = state;
    }
    if (schedule.counts_cells) {
        of(Slot::tickets) = schedule.ball_count * sizeof(std::uint32_t);
        of(Slot::scattered_keys) = schedule.ball_count * sizeof(Key);
        of(Slot::tile_counts) = of(Slot::used_tiles);
    }
    of(Slot::origins) = can_keep_order(schedule) ? schedule.ball_count * sizeof(std::uint32_t) : 0;
    of(Slot::status) = sizeof(Status);
    return bytes;
}

double bytes_per_ball(const Schedule& schedule) {
    auto bytes = bytes_of(schedule);
    for (const Slot slot : {Slot::cell_ranges, Slot::used_tiles, Slot::tile_counts, Slot::status}) {
        bytes[static_cast<std::size_t>(slot)] = 0;
    }
    const auto sum = std::accumulate(bytes.begin(), bytes.end(), std::size_t{0});
    return schedule.ball_count == 0 ? 0.0 : static_cast<double>(sum) / schedule.ball_count;
}

std::size_t least_bytes(const Dispatch& dispatch, const Schedule& schedule) {
    const auto bytes = bytes_of(schedule);
    const Shader shader = dispatch.program.shader;
    std::size_t sum = 0;
    for (const Slot slot : dispatch.reads) {
        sum += slot == Slot::cell_ranges ? 0 : bytes[static_cast<std::size_t>(slot)];
    }
    for (const Slot slot : dispatch.writes) {
        const bool in_part = slot == Slot::cell_ranges || slot == Slot::used_tiles ||
                             (slot == Slot::keys && shader == Shader::bitonic_sort);
        sum += in_part ? 0 : bytes[static_cast<std::size_t>(slot)];
    }
    return sum;
}

std::size_t least_bytes(const Schedule& schedule, Stage stage) {
    std::size_t sum = 0;
    for (const Dispatch& dispatch : schedule.dispatches) {
        sum += dispatch.stage == stage ? least_bytes(dispatch, schedule) : 0;
    }
    return sum;
}

BarrierCount count_barriers(const Schedule& schedule) {
    Hazards hazards;
    run_in_the_books(schedule, hazards);
    run_in_the_books(schedule, hazards);  // both roles of the state have been written
    return run_in_the_books(schedule, hazards);
}

std::uint32_t dispatches_of(const Schedule& schedule, Stage stage) {
    return static_cast<std::uint32_t>(std::ranges::count(schedule.dispatches, stage, &Dispatch::stage));
}

std::vector<Slot> bound_slots(const Schedule& schedule) {
    std::set<Slot> slots;
    for (const Dispatch& dispatch : schedule.dispatches) {
        slots.insert(dispatch.reads.begin(), dispatch.reads.end());
        slots.insert(dispatch.writes.begin(), dispatch.writes.end());
    }
    return {slots.begin(), slots.end()};
}

std::vector<std::string> absences(const Schedule& schedule) {
    const Features features = schedule.features;
    const bool contact = features.has(Feature::contact);
    const bool touching = contact || features.has(Feature::walls);
    std::vector<std::string> absent;
    const auto note = [&absent](bool is_absent, const char* what) {
        if (is_absent) {
            absent.emplace_back(what);
        }
    };
    note(schedule.key_count == 0, "grid");
    note(schedule.key_count == 0, "sort");
    note(schedule.in_place, "second state");
    note(!contact, "neighbours");
    note(contact && !features.has(Feature::dashpot), "neighbours' velocities");
    note(!features.has(Feature::walls), "walls");
    note(touching && !features.has(Feature::dashpot), "dashpot");
    note(!features.has(Feature::unequal_radii), touching ? "radius read" : "radius");
    note(!features.has(Feature::unequal_masses), touching ? "mass read" : "mass");
    note(touching && !features.has(Feature::ball_restitution), "restitution per ball");
    note(!features.has(Feature::gravity), "gravity");
    note(!features.has(Feature::drag), "drag");
    note(!features.has(Feature::diagnostics), "diagnostics");
    return absent;
}

}  // namespace ballpit
