// A7, A8 and A16: balls fly against walls, with and without a dashpot.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/analytic_scene.h"
#include "support/catch.h"
#include "support/oracle.h"

namespace ballpit::test {

namespace {

using std::numbers::pi;

std::string_view name_of(Integrator integrator) { return integrator_names[static_cast<std::size_t>(integrator)]; }

// A ball flies against the lower wall along x; the contact begins `phase` substeps after the end of one.
Scene impact_scene(Integrator integrator, double dt, double speed) {
    std::vector<BallSpec> balls;
    for (int i = 0; i < 64; ++i) {
        const dvec3 place = 0.25 * bench(static_cast<std::size_t>(i), 1.0);
        balls.push_back(ball(place + dvec3(-0.9 + speed * dt * (3.0 + (i + 0.5) / 64.0), 0, 0), {-speed, 0, 0}));
    }
    Scene scene = wall_scene(balls, integrator, dt);
    scene.half_extent = dvec3(1.0, 4.0, 4.0);
    return scene;
}

struct Rebound {
    double restitution;
    double force_ends;  // s after the contact's begin: the last change of velocity
};

Rebound discrete_rebound(const Scene& scene, std::size_t i, const SpringContact& contact, int steps) {
    const double speed = -scene.balls[i].velocity.x;
    DiscreteLine line{stored(scene.balls[i].position.x) + scene.half_extent.x - stored(0.1), -speed, 0.0};
    const double begin = line.x / speed;
    double last = 0.0;
    for (int step = 1; step <= steps; ++step) {
        const double before = line.v;
        line.step(scene.settings.integrator, scene.settings.dt, 0.0, contact);
        last = line.v != before ? step * scene.settings.dt : last;
    }
    return {line.synchronised(0.0, contact) / speed, last - begin};
}

}  // namespace

void a7_a8_restitution_with_dashpot(const Machine& machine) {
    struct Row {
        double zeta, e;
        bool limit_force;
    };
    for (const Row& row :
         {Row{.05, .85446789, false}, Row{.1, .72924761, false}, Row{.2, .5266206, false}, Row{.3, .3723261, false},
          Row{.5, .16303353, false}, Row{.05, .8587581, true}, Row{.1, .7440794, true}, Row{.2, .57174003, true},
          Row{.3, .45097545, true}, Row{.5, .29843606, true}, Row{.70711, .20787958, true}, Row{.9, .15528275, true}}) {
        const double e = exact_restitution(row.zeta, row.limit_force);
        REQUIRE(e == Approx(row.e).epsilon(1e-5));
        for (const int n : {32, 64}) {
            const double dt = pi / wall_frequency / n;
            const int steps = 2 * n + 8;
            Scene scene = impact_scene(Integrator::leapfrog, dt, 1.0);
            scene.settings.laws.restitution = true;
            scene.settings.restitution = e;
            scene.settings.limit_force = row.limit_force;
            const Motion end = motion_after(machine, scene, steps * dt);
            double mean = 0.0;
            double worst = 0.0;
            double duration = 0.0;
            const SpringContact contact{canonical_stiffness, 1.0, row.zeta, row.limit_force};
            for (std::size_t i = 0; i < end.v.size(); ++i) {
                const Rebound discrete = discrete_rebound(scene, i, contact, steps);
                CAPTURE(row.zeta, row.limit_force, n, i);
                CHECK(std::abs(end.v[i].x - discrete.restitution) <= machine.tolerance(1e-6, 3e-5));
                mean += (end.v[i].x - e) / 64.0;
                worst = std::max(worst, std::abs(end.v[i].x - e));
                duration += discrete.force_ends * wall_frequency / 64.0;
            }
            CAPTURE(row.zeta, row.limit_force, n, mean * n, worst * n, duration);
            // First and last substep may count the dashpot up to half a substep too long or too short: 2 pi zeta e / n
            // for both. And it acts on the velocity of half a substep before, which makes zeta larger by zeta^2 h / 2.
            const double edges = 2.0 * pi * row.zeta * e;
            const double bias = 0.5 * pi * pi * row.zeta * row.zeta * e / std::pow(1.0 - row.zeta * row.zeta, 1.5);
            const double limit = row.limit_force ? 1.2 * edges : std::max(1.2 * edges, edges + bias);
            CHECK(worst <= limit / n + machine.tolerance(1e-6, 3e-5));
            CHECK(duration == Approx(exact_contact_phase(row.zeta, row.limit_force)).margin(1.5 * pi / n));
            if (!row.limit_force) {  // -0.036 / n at zeta = 0.1, -0.11 / n at 0.2
                CHECK(mean * n == Approx(-bias).margin(0.1 * bias + 0.02 * edges + machine.tolerance(0.0, 3e-5 * n)));
            }
        }
    }
}

void a16_corner(const Machine& machine) {
    const dvec3 v(-1, -1.5, -2);
    for (const int n : {20, 50}) {
        const double dt = pi / wall_frequency / n;
        for (const Integrator integrator : symplectic) {
            std::vector<BallSpec> balls;
            for (int i = 0; i < 64; ++i) {  // every other one into the opposite corner
                const double side = i % 2 == 0 ? 1.0 : -1.0;
                balls.push_back(ball(side * (dvec3(-0.9) - v * dt * (3.0 + (i + 0.5) / 64.0)), side * v));
            }
            Scene scene = wall_scene(balls, integrator, dt);
            scene.half_extent = dvec3(1.0);
            const int steps = 2 * n + 8;
            const Motion end = motion_after(machine, scene, steps * dt);
            for (std::size_t i = 0; i < 64; ++i) {
                for (int axis = 0; axis < 3; ++axis) {
                    CAPTURE(n, axis, name_of(integrator), i);
                    const double side = i % 2 == 0 ? 1.0 : -1.0;
                    DiscreteLine line{side * stored(balls[i].position[axis]) + 1.0 - stored(0.1), v[axis], 0.0};
                    const SpringContact wall;
                    for (int step = 0; step < steps; ++step) {
                        line.step(integrator, dt, 0.0, wall);
                    }
                    const double after = side * end.v[i][axis];
                    CHECK(std::abs(-after / v[axis] - 1.0) <= 2.1 / (n * n * n) + machine.rounding * 3e-5);
                    CHECK(std::abs(after - line.synchronised(0.0, wall)) <= machine.tolerance(1e-11, 6e-5));
                }
            }
        }
    }
}

}  // namespace ballpit::test
