#include "support/analytic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/contact.h"
#include "core/simulation.h"
#include "support/catch.h"

namespace ballpit::test {

namespace {

using std::numbers::pi;

constexpr double canonical_stiffness = 1e4;                          // N/m, with balls of 1 kg and 0.1 m
const double pair_frequency = std::sqrt(2.0 * canonical_stiffness);  // rad/s: m_eff = 1/2
const double wall_frequency = std::sqrt(canonical_stiffness);

BallSpec ball(const dvec3& position, const dvec3& velocity, double radius = 0.1, double mass = 1.0) {
    return {position, velocity, radius, mass, std::nullopt};
}

Scene scene_of(std::vector<BallSpec> balls, Integrator integrator, double dt) {
    Scene scene;
    scene.name = "analytic";
    scene.half_extent = dvec3(4.0);
    scene.balls = std::move(balls);
    scene.settings.balls = static_cast<std::uint32_t>(scene.balls.size());
    scene.settings.integrator = integrator;
    scene.settings.dt = dt;
    scene.settings.substeps = 1;
    scene.settings.stiffness = canonical_stiffness;
    scene.settings.restitution = 1.0;
    return scene;
}

Simulation start(const Machine& machine, const Scene& scene) { return {scene, scene.settings, 0, machine.make()}; }

void run(Simulation& simulation, double time, double dt) {
    const auto substeps = static_cast<int>(std::lround(time / dt));
    for (int i = 0; i < substeps; ++i) {
        simulation.substep();
    }
}

// Final state at `time`; positions and velocities in double.
struct Motion {
    std::vector<dvec3> x;
    std::vector<dvec3> v;
};

Motion motion_of(Simulation& simulation) {
    const BallState state = simulation.synchronised_state();
    Motion motion;
    for (std::size_t i = 0; i < state.count(); ++i) {
        motion.x.emplace_back(state.positions[i]);
        motion.v.emplace_back(state.velocities[i]);
    }
    return motion;
}

Motion motion_after(const Machine& machine, const Scene& scene, double time) {
    Simulation simulation = start(machine, scene);
    run(simulation, time, scene.settings.dt);
    return motion_of(simulation);
}

struct Collision {
    double restitution;  // -(v1' - v2') / (v1 - v2)
    double max_overlap;  // m, the largest sampled
    double duration;     // s, substeps in contact times dt
    double momentum;     // kg m/s afterwards
};

// Two balls meet head on along x; the contact begins `phase` of a substep before a substep ends.
Collision collide(const Machine& machine, Integrator integrator, double dt, double phase, const BallSpec& left,
                  const BallSpec& right) {
    const double closing = left.velocity.x - right.velocity.x;
    const double gap = closing * dt * (3.0 + phase);
    const double reach = left.radius + right.radius;
    BallSpec a = left;
    BallSpec b = right;
    a.position = {-0.5 * (gap + reach), 0, 0};
    b.position = {0.5 * (gap + reach), 0, 0};
    Scene scene = scene_of({a, b}, integrator, dt);
    scene.settings.laws.contact = true;
    Simulation simulation = start(machine, scene);
    Collision result{0.0, 0.0, 0.0, 0.0};
    bool touched = false;
    for (int i = 0; i < 100000; ++i) {
        simulation.substep();
        const Motion motion = motion_of(simulation);
        const double overlap = reach - (motion.x[1].x - motion.x[0].x);
        if (overlap > 0.0) {
            touched = true;
            result.duration += dt;
            result.max_overlap = std::max(result.max_overlap, overlap);
        } else if (touched) {
            result.restitution = (motion.v[1].x - motion.v[0].x) / closing;
            result.momentum = a.mass * motion.v[0].x + b.mass * motion.v[1].x;
            return result;
        }
    }
    return result;
}

const BallSpec equal_left = ball({}, {1, 0, 0});
const BallSpec equal_right = ball({}, {-1, 0, 0});

// Largest |e - 1| over phases of the contact's begin within a substep.
double worst_restitution_error(const Machine& machine, Integrator integrator, double substeps_per_contact) {
    const double dt = pi / pair_frequency / substeps_per_contact;
    double worst = 0.0;
    for (int phase = 0; phase < 8; ++phase) {
        const Collision c = collide(machine, integrator, dt, (phase + 0.5) / 8.0, equal_left, equal_right);
        worst = std::max(worst, std::abs(c.restitution - 1.0));
    }
    return worst;
}

constexpr std::array symplectic = {Integrator::leapfrog, Integrator::symplectic_euler, Integrator::velocity_verlet};

Scene drag_scene(const BallSpec& thrown, Integrator integrator, double dt) {
    Scene scene = scene_of({thrown}, integrator, dt);
    scene.settings.laws.gravity = true;
    scene.settings.laws.drag = true;
    scene.settings.drag = 0.1;
    return scene;
}

}  // namespace

void a1_free_fall(const Machine& machine) {
    for (const double dt : {1.0 / 60.0, 1.0 / 960.0}) {
        for (std::size_t i = 0; i < integrator_names.size(); ++i) {
            const auto integrator = static_cast<Integrator>(i);
            Scene scene = scene_of({ball({0, 0, 10}, {1, -2, 3})}, integrator, dt);
            scene.settings.laws.gravity = true;
            const Motion end = motion_after(machine, scene, 1.0);
            // The Euler integrators see the speed of one end of each substep: half a substep of fall too much or
            // little.
            const double lag = integrator == Integrator::symplectic_euler ? -0.5
                               : integrator == Integrator::forward_euler  ? 0.5
                                                                          : 0.0;
            const double z = 8.1 + lag * 9.8 * dt;
            const double steps = 1.0 / dt;
            const double tolerance = 1e-6 + machine.rounding * 20.0 * 1e-6 * std::sqrt(steps);
            CAPTURE(integrator_names[i], dt, z);
            CHECK(std::abs(end.x[0].z - z) <= tolerance);
            CHECK(std::abs(end.x[0].x - 1.0) <= tolerance);
            CHECK(std::abs(end.x[0].y + 2.0) <= tolerance);
            CHECK(std::abs(end.v[0].z + 6.8) <= tolerance);
            CHECK(end.v[0].x == 1.0);
            CHECK(end.v[0].y == -2.0);
        }
    }
}

void a2_projectile_with_drag(const Machine& machine) {
    const BallSpec thrown = ball({}, {5, 0, 10});
    // z(2 s) and v(2 s) of the exact solution; the scene's origin is the muzzle.
    constexpr double x = 9.063462346, z = -0.2292133242, vx = 4.093653765, vz = -9.577078668;
    for (const double dt : {1.0 / 60.0, 1.0 / 240.0}) {
        for (const Integrator integrator : {Integrator::leapfrog, Integrator::velocity_verlet}) {
            const Motion end = motion_after(machine, drag_scene(thrown, integrator, dt), 2.0);
            const double rounding = 1e-6 + machine.rounding * 2e-4;
            CAPTURE(dt, end.x[0].z);
            CHECK(std::abs(end.x[0].z - z) <= 0.15 * dt * dt + rounding);
            CHECK(std::abs(end.x[0].x - x) <= 0.15 * dt * dt + rounding);
            CHECK(std::abs(end.v[0].x - vx) <= rounding);  // the drag factor is exact
            CHECK(std::abs(end.v[0].z - vz) <= rounding);
        }
        const Motion euler = motion_after(machine, drag_scene(thrown, Integrator::symplectic_euler, dt), 2.0);
        CHECK(std::abs(euler.x[0].z - z) <= 10.8 * dt);
        CHECK(std::abs(euler.x[0].z - z) >= 8.0 * dt);  // first order, and it shows
        CHECK(std::abs(euler.v[0].z - vz) <= 1e-6 + machine.rounding * 2e-4);
    }
}

void a3_terminal_velocity(const Machine& machine) {
    struct Row {
        double time, v;
    };
    for (const Row& row : {Row{1.0, -9.325933032}, Row{10.0, -61.94781477}, Row{100.0, -97.99555081}}) {
        const Motion end = motion_after(machine, drag_scene(ball({}, {}), Integrator::leapfrog, 1.0 / 60.0), row.time);
        CAPTURE(row.time);
        CHECK(end.v[0].z == Approx(row.v).epsilon(1e-7 + machine.rounding * 1e-5));
    }
    const Motion fallen = motion_after(machine, drag_scene(ball({}, {}), Integrator::leapfrog, 1.0 / 240.0), 10.0);
    CHECK(fallen.x[0].z == Approx(-360.5218523).epsilon(1e-6 + machine.rounding * 1e-4));
}

void a4_head_on(const Machine& machine) {
    const double rounding = machine.rounding * 3e-5;
    for (const int n : {8, 16, 20, 50}) {
        const double dt = pi / pair_frequency / n;
        for (int phase = 0; phase < 8; ++phase) {
            for (const Integrator integrator : symplectic) {
                const Collision c = collide(machine, integrator, dt, (phase + 0.5) / 8.0, equal_left, equal_right);
                CAPTURE(n, phase, integrator_names[static_cast<std::size_t>(integrator)]);
                CHECK(std::abs(c.restitution - 1.0) <= 2.1 / (n * n * n) + rounding);
                CHECK(c.max_overlap <= 0.01414213562 * (1.0 + 1.24 / (n * n)) + rounding);
                CHECK(c.max_overlap >= 0.01414213562 * (1.0 - 1.24 / (n * n)) - rounding);
                CHECK(std::abs(c.duration - 0.02221441469) <= 1.01 * dt);
                CHECK(std::abs(c.momentum) <= 4 * 1.2e-7);
            }
            // The historical integrator and forward Euler gain, by as much as theory says.
            const Collision taylor =
                collide(machine, Integrator::historical, dt, (phase + 0.5) / 8.0, equal_left, equal_right);
            if (n >= 20) {
                const double gain = std::exp(pi * pi / (4.0 * n)) - 1.0;
                CHECK(taylor.restitution - 1.0 == Approx(gain).epsilon(0.02));
                const Collision euler =
                    collide(machine, Integrator::forward_euler, dt, (phase + 0.5) / 8.0, equal_left, equal_right);
                CHECK(euler.restitution - 1.0 == Approx(std::exp(pi * pi / (2.0 * n)) - 1.0).epsilon(0.08));
            }
        }
    }
}

void a4_order_of_convergence(const Machine& machine) {
    const auto order = [&](Integrator integrator) {
        return std::log2(worst_restitution_error(machine, integrator, 16) /
                         worst_restitution_error(machine, integrator, 32));
    };
    CHECK(order(Integrator::leapfrog) == Approx(3.0).margin(0.3));
    CHECK(order(Integrator::symplectic_euler) == Approx(3.0).margin(0.3));
    CHECK(order(Integrator::velocity_verlet) == Approx(3.0).margin(0.3));
    CHECK(order(Integrator::historical) == Approx(1.0).margin(0.2));
    CHECK(order(Integrator::forward_euler) == Approx(1.0).margin(0.3));
    // Where a contact does not last a whole number of substeps, first and last overlap differ: h^2 / 8.
    for (const double n : {10.5, 21.3, 40.5}) {
        const double error = worst_restitution_error(machine, Integrator::leapfrog, n);
        CAPTURE(n);
        CHECK(error <= 1.3 / (n * n));
        CHECK(error >= 0.3 / (n * n));
    }
}

void a5_unequal_balls(const Machine& machine) {
    const double dt = 0.02961921959 / 50;
    for (const Integrator integrator : symplectic) {
        const Collision c = collide(machine, integrator, dt, 0.3, ball({}, {1, 0, 0}), ball({}, {}, 0.2, 8.0));
        CAPTURE(integrator_names[static_cast<std::size_t>(integrator)]);
        // e = 1 and the momentum give v1 = -7/9, v2 = 2/9.
        CHECK(std::abs(c.restitution - 1.0) <= 2.1 / (50.0 * 50.0 * 50.0) + machine.rounding * 3e-5);
        CHECK(c.momentum == Approx(1.0).epsilon(1e-6));
        CHECK(c.max_overlap == Approx(0.009428090416).epsilon(1.24 / 2500.0 + machine.rounding * 3e-5));
        CHECK(std::abs(c.duration - 0.02961921959) <= 1.01 * dt);
    }
}

void a8_restitution_with_dashpot(const Machine& machine) {
    // A ball against a wall, e asked for and e found, averaged over 16 phases; n substeps a contact.
    constexpr int n = 50;
    const double dt = pi / wall_frequency / n;
    for (const bool limit_force : {true, false}) {
        for (const double e : {0.9, 0.6, 0.3}) {
            double sum = 0.0;
            for (int phase = 0; phase < 16; ++phase) {
                Scene scene = scene_of({ball({-3.9 + dt * (3.0 + (phase + 0.5) / 16.0), 0, 0}, {-1, 0, 0})},
                                       Integrator::leapfrog, dt);
                scene.settings.laws.contact = scene.settings.laws.walls = scene.settings.laws.restitution = true;
                scene.settings.restitution = e;
                scene.settings.limit_force = limit_force;
                sum += motion_after(machine, scene, 3.0 * n * dt).v[0].x;
            }
            CAPTURE(limit_force, e);
            const double zeta = damping_ratio_from_restitution(e, limit_force);
            CHECK(std::abs(sum / 16.0 - e) <= 1.2 * 2.0 * pi * zeta * e / n);
        }
    }
}

void a9_static_overlap(const Machine& machine) {
    struct Row {
        double half_extent, tolerance;
    };
    for (const Row& row : {Row{1.0, 1.2e-7}, Row{100.0, 1.53e-5}}) {
        for (std::size_t i = 0; i < integrator_names.size(); ++i) {
            // c = 20 N s/m is zeta = 0.1; c > k dt, so that even forward Euler comes to rest.
            Scene scene = scene_of({ball({0, 0, 0.1 - row.half_extent}, {})}, static_cast<Integrator>(i), 1.0 / 1920.0);
            scene.half_extent = dvec3(row.half_extent);
            scene.settings.laws.gravity = scene.settings.laws.contact = scene.settings.laws.walls =
                scene.settings.laws.restitution = true;
            scene.settings.restitution = restitution_from_damping_ratio(0.1, true);
            const Motion end = motion_after(machine, scene, 4.0);
            CAPTURE(row.half_extent, integrator_names[i]);
            // The answer is handed out in float: its rounding stays also for the reference.
            CHECK(std::abs(0.1 - (end.x[0].z + row.half_extent) - 9.8e-4) <= row.tolerance);
        }
    }
}

void a14_newtons_cradle(const Machine& machine) {
    constexpr std::array exact = {-0.132279485, -0.07532917, -0.031010829, 0.29621775, 0.942401733};
    for (const int n : {20, 50}) {
        const double dt = pi / pair_frequency / n;
        std::vector<BallSpec> balls;
        for (int i = 0; i < 5; ++i) {
            balls.push_back(ball({-0.5 + 0.25 * i, 0, 0}, {i == 0 ? 1.0 : 0.0, 0, 0}, 0.125));
        }
        Scene scene = scene_of(balls, Integrator::leapfrog, dt);
        scene.settings.laws.contact = true;
        const Motion end = motion_after(machine, scene, 10.0 * n * dt);
        for (std::size_t i = 0; i < exact.size(); ++i) {
            CAPTURE(n, i);
            CHECK(std::abs(end.v[i].x - exact[i]) <= 0.8 / (n * n) + machine.rounding * 3e-5);
        }
    }
}

void a16_corner(const Machine& machine) {
    const dvec3 v(-1, -1.5, -2);
    for (const int n : {20, 50}) {
        const double dt = pi / wall_frequency / n;
        for (const Integrator integrator : symplectic) {
            Scene scene = scene_of({ball(dvec3(-3.9) - v * dt * 3.3, v)}, integrator, dt);
            scene.settings.laws.contact = scene.settings.laws.walls = true;
            const Motion end = motion_after(machine, scene, 3.0 * n * dt);
            for (int axis = 0; axis < 3; ++axis) {
                CAPTURE(n, axis, integrator_names[static_cast<std::size_t>(integrator)]);
                CHECK(std::abs(-end.v[0][axis] / v[axis] - 1.0) <= 2.1 / (n * n * n) + machine.rounding * 1e-4);
            }
        }
    }
}

}  // namespace ballpit::test
