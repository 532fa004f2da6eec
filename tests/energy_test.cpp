// Sums over a state: energies, momentum, overlaps; and that leapfrog keeps the energy of an elastic gas.
#include "measure/energy.h"

#include <memory>

#include "core/simulation.h"
#include "cpu/cpu_backend.h"
#include "support/catch.h"
#include "support/scenes.h"

using namespace ballpit;
using measure::totals_of;

namespace {

Features features_of(std::initializer_list<Feature> list) {
    Features features;
    for (const Feature feature : list) {
        features.add(feature);
    }
    return features;
}

measure::Totals totals(Simulation& simulation) {
    return totals_of(simulation.synchronised_state(), simulation.settings(), simulation.features(), simulation.box());
}

}  // namespace

TEST_CASE("energies and momentum of two overlapping balls at a wall", "[measure]") {
    BallState state;
    state.positions = {vec4(0.0f, 0, 0, 0.5f), vec4(0.75f, 0, 0, 0.5f)};
    state.velocities = {vec4(1, 2, 0, 2), vec4(0, 0, -3, 4)};
    Settings settings;
    settings.stiffness = 100.0;
    settings.gravity = {0, 0, -10};
    const auto all = features_of({Feature::gravity, Feature::contact, Feature::walls});
    const auto sum = totals_of(state, settings, all, dvec3(1.0, 2.0, 2.0));
    CHECK(sum.kinetic == 0.5 * 2 * 5 + 0.5 * 4 * 9);
    CHECK(sum.potential == 0.0);
    CHECK(sum.momentum == dvec3(2, 4, -12));
    CHECK(sum.contacts == 1);
    CHECK(sum.max_overlap == 0.25);  // of the pair, and as much of the second ball with the wall
    CHECK(sum.elastic == Approx(0.5 * 100.0 * (0.25 * 0.25 + 0.25 * 0.25)));
    const auto no_laws = totals_of(state, settings, Features{}, dvec3(1.0, 2.0, 2.0));
    CHECK(no_laws.elastic == 0.0);
    CHECK(no_laws.contacts == 0);
    CHECK(no_laws.kinetic == sum.kinetic);
    state.positions[1].z = 1.5f;
    CHECK(totals_of(state, settings, all, dvec3(10)).potential == Approx(4 * 10 * 1.5));
}

TEST_CASE("no balls have no energy", "[measure]") {
    const auto sum = totals_of(BallState{}, Settings{}, features_of({Feature::contact, Feature::walls}), dvec3(1.0));
    CHECK(sum.kinetic == 0.0);
    CHECK(sum.contacts == 0);
}

TEST_CASE("an elastic gas keeps its energy, and the historical integrator heats it", "[measure]") {
    const Scene scene = test::shipped_scene("elastic_gas");
    const auto drift = [&](Integrator integrator) {
        Settings settings = scene.settings;
        settings.balls = 1000;
        settings.integrator = integrator;
        Simulation simulation(scene, settings, 1, std::make_unique<cpu::CpuBackend<float>>());
        const auto energy = [&] {
            const auto sum = totals(simulation);
            return sum.kinetic + sum.elastic;
        };
        const double before = energy();
        for (int i = 0; i < 60; ++i) {
            simulation.step();
        }
        return energy() / before - 1.0;
    };
    CHECK(std::abs(drift(Integrator::leapfrog)) < 0.005);
    CHECK(drift(Integrator::historical) > 0.02);
}

TEST_CASE("drag and dashpots only take energy", "[measure]") {
    const Scene scene = test::shipped_scene("pile");
    Settings settings = scene.settings;
    settings.balls = 500;
    Simulation simulation(scene, settings, 2, std::make_unique<cpu::CpuBackend<float>>());
    const auto energy = [&] {
        const auto sum = totals(simulation);
        return sum.kinetic + sum.potential + sum.elastic;
    };
    double before = energy();
    for (int i = 0; i < 90; ++i) {
        simulation.step();
        const double now = energy();
        CHECK(now < before + 1e-4 * std::abs(before));
        before = now;
    }
}

TEST_CASE("a free gas keeps its momentum", "[measure]") {
    // Far from walls only pairs act, and each force has its opposite (A28).
    Scene scene = test::shipped_scene("elastic_gas");
    scene.settings.laws.walls = false;
    scene.fill->region = {dvec3(-1), dvec3(1)};
    Settings settings = scene.settings;
    settings.balls = 300;
    Simulation simulation(scene, settings, 1, std::make_unique<cpu::CpuBackend<float>>());
    const dvec3 before = totals(simulation).momentum;
    double scale = 0.0;
    for (const vec4& v : simulation.raw_state().velocities) {
        scale += static_cast<double>(v.w * glm::length(vec3(v)));
    }
    for (int i = 0; i < 60; ++i) {
        simulation.step();
    }
    CHECK(glm::distance(totals(simulation).momentum, before) <= 2e-7 * scale);
}
