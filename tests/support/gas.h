// Sums over a gas in motion, for the statistical cases. In double, from the positions and velocities that the program
// hands out; forces are those of the linear spring, computed here.
#pragma once

#include <vector>

#include "core/simulation.h"

namespace ballpit::test {

struct GasSums {
    double kinetic = 0.0;      // J; with leapfrog's velocities, which lag by half a substep
    double pair_virial = 0.0;  // J: distance times force over all touching pairs
    double wall_virial = 0.0;  // J: force of each wall times the ball's distance from the middle
    double wall_force = 0.0;   // N, all six
    double floor_force = 0.0;  // N
};

/// Of one moment. `springs`: whether forces are asked for; they need all pairs.
GasSums gas_sums(Simulation& simulation, bool springs);

/// Balls whose centres lie within a cube of this half extent.
int balls_within(Simulation& simulation, double half_extent);

/// Speeds of all balls, and heights over the floor.
std::vector<double> speeds(Simulation& simulation);
std::vector<double> heights(Simulation& simulation);

/// chi^2 per degree of freedom of `speeds` against Maxwell's distribution of the same mean square, in `bins` of equal
/// probability.
double maxwell_chi_squared(const std::vector<double>& speeds, int bins);

}  // namespace ballpit::test
