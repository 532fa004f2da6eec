#include "support/probe_contract.h"

#include <cmath>
#include <numbers>

#include "core/contact.h"
#include "core/world.h"
#include "support/catch.h"
#include "support/scenes.h"

namespace ballpit::test {

namespace {

using measure::ProbeGroup;
using measure::ProbeQuestion;
using measure::ProbeResult;
using std::numbers::pi;

constexpr double float_error = 3e-5;  // of a restitution, 1 m from the origin

// Whether worst and mean are within what the phases and the bias of the lagging dashpot allow (docs/accuracy.md).
struct DampedBounds {
    double worst;
    double bias;
    double bias_margin;
};

DampedBounds damped_bounds(double zeta, double e, double n) {
    const double edges = 2.0 * pi * zeta * e;
    const double bias = 0.5 * pi * pi * zeta * zeta * e / std::pow(1.0 - zeta * zeta, 1.5);
    return {std::max(1.2 * edges, edges + bias) / n + float_error, -bias / n,
            (0.1 * bias + 0.02 * edges) / n + float_error};
}

}  // namespace

ProbeQuestion question_of(const Scene& scene, std::uint32_t balls) {
    const World world = make_world(scene, balls, seed_of(scene));
    Settings settings = scene.settings;
    settings.balls = balls;
    return {settings, measure::probe_scene(world.balls, settings, world.box, variety_of(world.balls))};
}

ProbeQuestion canonical_question(bool wall, double substeps_a_contact) {
    ProbeQuestion question;
    Settings& settings = question.settings;
    settings.laws = {};
    settings.laws.contact = !wall;
    settings.laws.walls = wall;
    settings.stiffness = 1e4;
    settings.substeps = 1;
    settings.dt = pi / (wall ? 100.0 : std::sqrt(2e4)) / substeps_a_contact;
    question.scene.variety = {false, false, false, 0.1f, 1.0f};
    question.scene.distance = 1.0;
    question.scene.radius = 0.1;
    question.scene.mass = 1.0;
    question.scene.typical_speed = 1.0;
    question.scene.largest_speed = 2.0;
    return question;
}

ProbeQuestion damped_question(double damping_ratio, bool limit_force, double substeps_a_contact) {
    ProbeQuestion question = canonical_question(true, substeps_a_contact);
    question.settings.laws.restitution = true;
    question.settings.limit_force = limit_force;
    question.settings.restitution = restitution_from_damping_ratio(damping_ratio, limit_force);
    question.scene.restitution = question.settings.restitution;
    return question;
}

void probe_finds_elastic_errors(Backend& backend) {
    for (const Integrator integrator :
         {Integrator::leapfrog, Integrator::symplectic_euler, Integrator::velocity_verlet}) {
        for (const bool wall : {false, true}) {
            for (const double n : {8.0, 16.0, 32.0}) {
                ProbeQuestion question = canonical_question(wall, n);
                question.settings.integrator = integrator;
                const ProbeResult result = run_probe(backend, question);
                REQUIRE(result.groups.size() == 2);
                for (const ProbeGroup& group : result.groups) {
                    CAPTURE(static_cast<int>(integrator), wall, n, group.largest);
                    CHECK(group.unending == 0);
                    CHECK(group.restitution.exact == 1.0);
                    CHECK(std::abs(group.restitution.worst - 1.0) <= 2.1 / (n * n * n) + float_error);
                    CHECK(group.restitution.error <= std::abs(group.restitution.worst - 1.0));
                    CHECK(std::abs(group.overlap.worst / group.overlap.exact - 1.0) <= 1.24 / (n * n) + 1e-4);
                    const double steps = group.duration.mean / question.settings.dt;
                    CHECK(steps == Approx(n - 0.411 / n).margin(0.05));  // 64 phases
                    CHECK(std::abs(group.gain.mean) <= 2.1 / (n * n * n) + float_error);
                }
            }
        }
    }
}

void probe_finds_historical_gain(Backend& backend) {
    for (const double n : {10.0, 25.0, 50.0}) {
        ProbeQuestion question = canonical_question(false, n);
        question.settings.integrator = Integrator::historical;
        const ProbeResult result = run_probe(backend, question);
        CAPTURE(n);
        REQUIRE(result.groups.size() == 2);
        const double expected = std::exp(pi * pi / (4.0 * n)) - 1.0;
        CHECK(result.groups[0].restitution.mean - 1.0 == Approx(expected).epsilon(0.02));
        CHECK(result.groups[0].gain.mean == Approx(std::exp(pi * pi / (2.0 * n)) - 1.0).epsilon(0.03));
    }
}

void probe_finds_damped_restitution(Backend& backend) {
    for (const double zeta : {0.05, 0.1, 0.2, 0.3}) {
        for (const bool limit_force : {false, true}) {
            for (const double n : {32.0, 64.0}) {
                const ProbeResult result = run_probe(backend, damped_question(zeta, limit_force, n));
                const double e = restitution_from_damping_ratio(zeta, limit_force);
                const DampedBounds bounds = damped_bounds(zeta, e, n);
                for (const ProbeGroup& group : result.groups) {
                    CAPTURE(zeta, limit_force, n, group.largest);
                    CHECK(group.restitution.exact == Approx(e).epsilon(1e-6));
                    CHECK(std::abs(group.restitution.worst - e) <= bounds.worst);
                    CHECK(group.duration.mean == Approx(group.duration.exact).epsilon(1.5 / n));
                    CHECK(group.overlap.mean == Approx(group.overlap.exact).epsilon(4.0 * zeta / n + 2.0 / (n * n)));
                    if (!limit_force) {
                        CHECK(group.restitution.mean - e == Approx(bounds.bias).margin(bounds.bias_margin));
                    }
                }
            }
        }
    }
}

bool damped_mean_is_right(Backend& backend) {
    const double zeta = 0.1;
    const double n = 32.0;
    const ProbeResult result = run_probe(backend, damped_question(zeta, false, n));
    const DampedBounds bounds = damped_bounds(zeta, restitution_from_damping_ratio(zeta, false), n);
    const measure::Spread& e = result.groups.at(0).restitution;
    return std::abs(e.mean - e.exact - bounds.bias) <= bounds.bias_margin &&
           std::abs(e.worst - e.exact) <= bounds.worst;
}

}  // namespace ballpit::test
