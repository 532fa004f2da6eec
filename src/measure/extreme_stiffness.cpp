// Steps that are too long for their springs: what fails must not fail in silence.
#include <algorithm>
#include <cmath>

#include "measure/extreme_rows.h"

namespace ballpit::measure {

namespace {

double energy(Simulation& simulation) {
    const Totals totals = totals_of(simulation);
    return totals.kinetic + totals.potential + totals.elastic;
}

// A ball that drops by 1.9 m onto a floor without loss; 16 substeps.
Scene drop(double stiffness) {
    Scene scene = extreme_scene("gravity,walls", 2.0);
    scene.settings.stiffness = stiffness;
    scene.settings.substeps = 16;
    put_ball(scene, {0, 0, 0}, {0, 0, 0});
    return scene;
}

struct Bounces {
    double most = 0.0;  // energy over that at the start, both counted from the floor
    bool finite = true;
    Light light = Light::green;
};

Light worst_light(Simulation& simulation) {
    Light light = Light::green;
    for (const Gauge& gauge : gauges(metered(simulation), simulation)) {
        light = std::max(light, gauge.light());
    }
    return light;
}

Bounces bounces_of(Simulation& simulation, std::uint64_t steps) {
    Bounces bounces;
    bounces.light = worst_light(simulation);
    const double floor = 9.8 * 1.9;  // J, that it can fall
    const double start = energy(simulation) + floor;
    for (std::uint64_t i = 0; i < steps && bounces.finite; ++i) {
        run_steps(simulation, 1);
        bounces.finite = std::isfinite(energy(simulation));
        bounces.most = std::max(bounces.most, (energy(simulation) + floor) / start);
    }
    return bounces;
}

// Settled, then left to itself: mean kinetic energy in units of m g r.
Scene pile(double restitution) {
    Scene scene = extreme_scene("gravity,contact,restitution,walls", 1.0);
    scene.half_extent = {0.25, 0.25, 1.0};
    scene.settings.stiffness = 1e4;
    scene.settings.restitution = restitution;
    fill_region(scene, 60, {0.05, 0.05}, 0.0, {-0.25, -0.25, -1.0}, {0.25, 0.25, 1.0});
    scene.fill->density = 1910.0;  // about 1 kg
    return scene;
}

double unrest(Simulation& simulation) {
    const MeterReading& reading = metered(simulation).reading;
    return reading.kinetic / (reading.mass * 9.8 * 0.05);
}

}  // namespace

void eight_decades_of_stiffness(ExtremeTrial& trial) {
    for (int decade = 0; decade <= 8; ++decade) {
        const double stiffness = std::pow(10.0, decade);
        Simulation simulation = trial.start(drop(stiffness));
        const Bounces bounces = bounces_of(simulation, 180);
        const bool right = bounces.finite && bounces.most < 1.05;
        trial.expect(right || bounces.light != Light::green,
                     "k = 1e" + std::to_string(decade) + ": energy at most x " + digits(bounces.most) + ", gauges " +
                         std::string(light_names[static_cast<std::size_t>(bounces.light)]));
        trial.note_signs(simulation);
    }
}

void beyond_the_critical_step(ExtremeTrial& trial) {
    Simulation settled = trial.start(pile(0.6));
    run_steps(settled, 120);
    const Scene scene = pile(0.6);
    trial.at_most("at the scene's own dt, unrest", unrest(settled), 1e-2, " m g r");
    const double ratio = gauge_of(settled, "dt / dt_c").value;
    const double dt = settled.settings().dt / settled.settings().substeps;
    for (const double share : {0.6, 3.0}) {
        Simulation simulation = trial.start(scene);
        run_steps(simulation, 120);
        Settings settings = simulation.settings();
        settings.substeps = 1;
        settings.dt = share * dt / ratio;
        simulation.change(settings);
        run_steps(simulation, 400);
        const double shaking = unrest(simulation);
        const Light light = gauge_of(simulation, "dt / dt_c").light();
        trial.expect(share < 1.0 ? shaking < 0.1 : !(shaking < 0.05),
                     digits(share) + " dt_c: unrest " + digits(shaking) + " m g r");
        trial.require((light == Light::red) == (share > 1.0),
                      "the gauge is " + std::string(light_names[static_cast<std::size_t>(light)]));
        trial.require(has_sign(simulation, "unstable_dt") == (share > 1.0), "the warning says something else");
        trial.note_signs(simulation);
    }
}

void heating_integrator(ExtremeTrial& trial) {
    for (const std::uint32_t substeps : {4u, 64u}) {
        Scene scene = drop(1e4);
        scene.settings.laws.restitution = true;
        scene.settings.restitution = 0.9;
        scene.settings.integrator = Integrator::historical;
        scene.settings.substeps = substeps;
        Simulation simulation = trial.start(scene);
        run_steps(simulation, 900);
        const Gauge gauge = gauge_of(simulation, "c - k dt / 2");
        const double speed = metered(simulation).reading.max_speed;
        trial.expect(gauge.value > 0.0 ? speed < 0.1 : speed > 0.1,
                     std::to_string(substeps) + " substeps: c - k dt / 2 = " + digits(gauge.value) +
                         " N s/m, after 15 s at " + digits(speed) + " m/s");
        trial.require((gauge.value > 0.0) != has_sign(simulation, "numerical_heating"),
                      "the warning says something else");
        trial.note_signs(simulation);
    }
}

void unequal_masses(ExtremeTrial& trial) {
    for (const double ratio : {1e3, 1e6}) {
        Scene scene = extreme_scene("gravity,contact,restitution,walls", 1.0);
        scene.settings.neighbours = NeighbourSearch::brute_force;
        scene.settings.restitution = 0.5;
        scene.settings.stiffness = 1e2 * ratio;  // the heavy one rests 0.1 m deep
        scene.settings.substeps = ratio > 1e4 ? 1024 : 64;
        const double deep = 9.8 * (ratio + 1.0) / scene.settings.stiffness;
        put_ball(scene, {0, 0, 0.3 - deep - 1.0}, {0, 0, 0}, 0.3, 1.0);
        put_ball(scene, {0, 0, 0.9 - deep - deep - 1.0}, {0, 0, 0}, 0.3, ratio);
        Simulation simulation = trial.start(scene);
        run_steps(simulation, ratio > 1e4 ? 8 : 30);
        const Gauge gauge = gauge_of(simulation, "dt / dt_c");
        trial.at_most("1:" + digits(ratio) + ", dt / dt_c of the light one's network", gauge.value, 0.9);
        trial.at_most("speed", metered(simulation).reading.max_speed, 0.1, " m/s");
        const BallState state = simulation.raw_state();
        trial.expect(state.positions[1].z > state.positions[0].z + 0.3f, "the heavy one stays above");
        trial.note_signs(simulation);
    }
}

void many_bounces(ExtremeTrial& trial) {
    Scene scene = extreme_scene("walls", 1.0);
    scene.settings.stiffness = 1e4;
    scene.settings.substeps = 1000;
    scene.settings.dt = 1000.0 / 960.0;
    for (int i = 0; i < 32; ++i) {  // speeds that are no whole number of each other
        put_ball(scene, {0, 0, 0}, {1.0 + 0.618 * i, 0, 0});
    }
    Simulation simulation = trial.start(scene);
    const double start = energy(simulation);
    double least = 1.0;
    double most = 1.0;
    for (int step = 0; step < 100; ++step) {
        run_steps(simulation, 1);
        const double share = energy(simulation) / start;
        least = std::min(least, share);
        most = std::max(most, share);
    }
    trial.at_most("energy of 32 balls over that at the start, at most", most, 1.2);
    trial.at_least("at least", least, 0.8);
    trial.note_signs(simulation);
}

}  // namespace ballpit::measure
