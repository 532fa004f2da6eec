#include "measure/extremes.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <exception>
#include <new>

#include "core/stopwatch.h"
#include "measure/extreme_rows.h"

namespace ballpit::measure {

namespace {

constexpr std::array<ExtremeCase, 27> table = {{
    {"E1", "two balls, and 32, with their centres in one place",
     "they part, in a direction of their ids, and no momentum appears", coincident_centres},
    {"E2", "NaN and Inf put into one ball of a crowd", "it goes into quarantine; the others keep every bit",
     numbers_that_are_none},
    {"E3", "1e30 m/s, 1e30 m", "as E2, or far outside and counted", enormous_speed},
    {"E4", "0, 1 and 2 balls", "runs; every sum is a number", few_balls},
    {"E5", "63, 64, 65 and 4097 balls", "the grid finds every touching pair, with both sorts", odd_counts},
    {"E6", "500 balls in one cell", "the same bits as brute force", all_in_one_cell},
    {"E7", "a ball 5 m outside the box", "comes back, by a force that grows no more", outside_the_box},
    {"E8", "a ball larger than the box", "rests between the walls, and is warned of", larger_than_the_box},
    {"E9", "a ball that drops onto stiffness 1 to 1e8 N/m, 16 substeps", "what gains energy is warned of",
     eight_decades_of_stiffness},
    {"E10", "stiffness 0", "they pass through each other; nothing is divided by it", zero_stiffness},
    {"E11", "masses, radii, coefficients that no ball has", "refused in one sentence", impossible_input},
    {"E12", "dt = 0, dt < 0", "no bit and no counter changes; refused", no_time},
    {"E13", "two balls head-on, ever faster", "bounce up to the energy limit; beyond, they pass and are warned of",
     tunnelling},
    {"E14", "two balls deep in each other, let go and relaxed", "the stored energy is told; relaxed, it is gone",
     deep_overlap},
    {"E15", "a dashpot too strong for the substep", "warned of; semi-implicit, it rests", overdamped},
    {"E16", "drag dt = 10", "the exact factor: nothing flips", drag_beyond_two},
    {"E17", "a pile at 0.6 and at 3 of its critical dt", "calm below, red above", beyond_the_critical_step},
    {"E18", "historical integrator, contacts with a dashpot", "settles where c > k dt / 2, and the gauge says where",
     heating_integrator},
    {"E19", "a ball at rest 10 m to 1e4 m from the origin", "right, or warned of", large_coordinates},
    {"E20", "a million steps", "the clock is right to the last digit", a_million_steps_of_the_clock},
    {"E21", "substeps of 1e-5 s at x = 100 m", "moves as it should, or is warned of; compensated sums move",
     tiny_substep},
    {"E22", "radii 1:4 and 1:100; cells too narrow", "every pair found; missed pairs are warned of", unequal_radii},
    {"E23", "masses 1:1e3 and 1:1e6, the heavy one above", "the light one rules dt; it carries", unequal_masses},
    {"E24", "balls bouncing for 1e5 substeps", "energy wanders, and does not grow", many_bounces},
    {"E25", "a pile, twice", "the same bits", order_of_neighbours},
    {"E26", "walls set to half a box at one blow", "they come at their own speed; nothing explodes", walls_closing_in},
    {"E28", "count, cells, dt, laws, scene changed while running", "goes on; all finite", changed_while_running},
}};

}  // namespace

std::span<const ExtremeCase> extreme_cases() { return table; }

bool ExtremeRow::passed() const { return !claims.empty() && std::ranges::all_of(claims, &ExtremeClaim::holds); }

std::string ExtremeRow::found() const {
    std::string text;
    for (const bool holds : {false, true}) {
        for (const ExtremeClaim& claim : claims) {
            if (claim.holds == holds) {
                text += (text.empty() ? "" : "; ") + std::string(holds ? "" : "NOT AS IT MUST BE: ") + claim.text;
            }
        }
    }
    return text;
}

std::string ExtremeRow::warned() const {
    std::string text;
    for (const ExtremeSign& sign : signs) {
        text += (text.empty() ? "" : ", ") + sign.key + " " + digits(sign.number);
    }
    return text;
}

ExtremeRow run_extreme(const ExtremeCase& extreme, const MakeBackend& make_backend) {
    const auto start = std::chrono::steady_clock::now();
    ExtremeTrial trial(make_backend);
    try {
        extreme.run(trial);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        trial.expect(false, std::string("broken off: ") + error.what());
    }
    return {std::string(extreme.id), std::string(extreme.input),        std::string(extreme.right), trial.claims(),
            trial.signs(),           milliseconds_since(start) / 1000.0};
}

}  // namespace ballpit::measure
