// Cases with a known answer (their numbers, A1 to A28, are those of docs/accuracy.md), for any backend. Besides the
// exact solution, most cases know what this very integrator must give ("discrete oracle"), which has no truncation
// error and can be held to rounding.
#pragma once

#include <functional>
#include <memory>

#include "core/backend.h"

namespace ballpit::test {

struct Machine {
    std::function<std::unique_ptr<Backend>()> make;
    /// What rounding adds to the tolerances: 0 for the reference in double, 1 in float.
    double rounding;
    /// A substep costs a large part of a millisecond, however few its balls: fewer integrators where one tells enough.
    bool slow = false;

    /// One of two tolerances, by what rounds.
    double tolerance(double in_double, double in_float) const { return rounding == 0.0 ? in_double : in_float; }
};

void a1_free_fall(const Machine& machine);
void a2_projectile_with_drag(const Machine& machine);
void a2_apex_and_range(const Machine& machine);
void a3_terminal_velocity(const Machine& machine);

void a4_head_on(const Machine& machine);
void a4_contact_of_no_whole_number_of_substeps(const Machine& machine);
void a5_unequal_balls(const Machine& machine);

void a6_bounces_on_the_floor(const Machine& machine);
void a6_with_compensated_sums(const Machine& machine);
void a6_touch_and_depth(const Machine& machine);
void a7_a8_restitution_with_dashpot(const Machine& machine);
void a9_static_overlap(const Machine& machine);
void a12_oscillation_in_contact(const Machine& machine);
void a16_corner(const Machine& machine);

void a10_column_at_rest(const Machine& machine);
void a10_column_at_the_stability_limit(const Machine& machine);
void a13_kicked_chain(const Machine& machine);
void a14_newtons_cradle(const Machine& machine);

void a15_oblique_scattering(const Machine& machine);
void a15_oblique_with_dashpot(const Machine& machine);

void a25_neighbours(const Machine& machine);
void a25_grid_of_a_scene(const Machine& machine);

void a26_mirror_rotation_permutation(const Machine& machine);
void a26_translation_and_boost(const Machine& machine);
void a27_time_reversal(const Machine& machine);
void a28_conservation(const Machine& machine);

// Orders of convergence: the slope of the error over halvings of dt, averaged over phases.
void order_of_free_flight(const Machine& machine);
void order_of_elastic_restitution(const Machine& machine);
void order_of_damped_restitution(const Machine& machine);
void order_of_bounces(const Machine& machine);
void order_of_chain(const Machine& machine);

}  // namespace ballpit::test
