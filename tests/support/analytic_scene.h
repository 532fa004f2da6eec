// What the verification cases share: scenes of few balls, and how they end. Many copies of one experiment, each with
// another phase of the substep, lie side by side in one run, so that averages over 64 phases cost little.
#pragma once

#include <array>
#include <vector>

#include "core/simulation.h"
#include "support/analytic.h"

namespace ballpit::test {

inline constexpr double canonical_stiffness = 1e4;  // N/m, with balls of 1 kg and 0.1 m
extern const double pair_frequency;                 // rad/s: m_eff = 1/2
extern const double wall_frequency;                 // rad/s: m_eff = 1

inline constexpr std::array symplectic = {Integrator::leapfrog, Integrator::symplectic_euler,
                                          Integrator::velocity_verlet};
inline constexpr std::array every_integrator = {Integrator::leapfrog, Integrator::symplectic_euler,
                                                Integrator::velocity_verlet, Integrator::forward_euler,
                                                Integrator::historical};

/// As a backend stores it: all state is loaded in float, also into the reference.
double stored(double value);

BallSpec ball(const dvec3& position, const dvec3& velocity, double radius = 0.1, double mass = 1.0);

/// One substep of `dt` a step, no law but those that the caller switches on, spring without loss.
Scene scene_of(std::vector<BallSpec> balls, Integrator integrator, double dt);

/// The same with walls.
Scene wall_scene(std::vector<BallSpec> balls, Integrator integrator, double dt);

/// Sixteen balls let go with their centres around 1.1 m over the floor, which is drop_depth (m) below the middle of the
/// box; nothing takes energy from them.
inline constexpr double drop_depth = 1.125;
Scene drop_scene(Integrator integrator, double dt);

/// A gas without loss in a box: `count` balls of gas_radius and 1 kg, a tenth of the volume, kT = 1 J.
Scene gas_scene(Integrator integrator, double dt, std::uint32_t count);
inline constexpr double gas_radius = 0.0575;  // m
inline constexpr double gas_stiffness = 1e5;  // N/m

Simulation start(const Machine& machine, const Scene& scene);
void run(Simulation& simulation, int substeps);
/// Whole substeps in `time`.
int substeps_in(double time, double dt);

/// Positions, and velocities of the same moment. On the reference in full double, elsewhere as they are handed out.
struct Motion {
    std::vector<dvec3> x;
    std::vector<dvec3> v;
};
Motion motion_of(Simulation& simulation);
Motion motion_after(const Machine& machine, const Scene& scene, double time);
/// Positions alone, which need no synchronising.
std::vector<dvec3> positions_of(Simulation& simulation);

/// A place for experiment number `i` of 64 across the x axis, `spacing` from its neighbours.
dvec3 bench(std::size_t i, double spacing);

/// Two balls that meet along x (right.velocity.x < left.velocity.x); positions are chosen by `collide`.
struct Encounter {
    BallSpec left;
    BallSpec right;
    double offset = 0.0;  // m, impact parameter: along y between the centres
    double phase = 0.5;   // substeps by which the contact begins after the end of one
};

struct Collision {
    double restitution = 0.0;  // -(v1' - v2') / (v1 - v2) along x
    double max_overlap = 0.0;  // m, the largest sampled
    double duration = 0.0;     // s, samples in contact times dt
    BallSpec left;             // as they began, in float
    BallSpec right;
    std::array<dvec3, 2> x;  // as they ended
    std::array<dvec3, 2> v;
    double time = 0.0;  // s from begin to end
};

/// Runs until `substeps` are over, which must be enough for every contact to end.
std::vector<Collision> collide(const Machine& machine, const Settings& settings, std::vector<Encounter> encounters,
                               int substeps);

/// 64 encounters of these balls at phases 1/128, 3/128...
std::vector<Encounter> at_64_phases(const BallSpec& left, const BallSpec& right, double offset = 0.0);

/// 101 balls of 1/8 m in a row, held together by the walls at its ends; the middle one gets `kick` m/s. Places and
/// overlaps are dyadic, so that floats hold the row at rest.
Scene chain_scene(Integrator integrator, double dt, double kick);

}  // namespace ballpit::test
