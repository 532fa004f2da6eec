// Cases with a known answer (the numbers A1 to A16 of the verification plan), for any backend. Besides the exact
// solution, most cases know what this very integrator must give ("discrete oracle"), which has no truncation error.
#pragma once

#include <functional>
#include <memory>

#include "core/backend.h"

namespace ballpit::test {

struct Machine {
    std::function<std::unique_ptr<Backend>()> make;
    /// What rounding adds to the tolerances: 0 for the reference in double, 1 in float.
    double rounding;
};

void a1_free_fall(const Machine& machine);
void a2_projectile_with_drag(const Machine& machine);
void a3_terminal_velocity(const Machine& machine);
void a4_head_on(const Machine& machine);
void a4_order_of_convergence(const Machine& machine);
void a5_unequal_balls(const Machine& machine);
void a8_restitution_with_dashpot(const Machine& machine);
void a9_static_overlap(const Machine& machine);
void a14_newtons_cradle(const Machine& machine);
void a16_corner(const Machine& machine);

}  // namespace ballpit::test
