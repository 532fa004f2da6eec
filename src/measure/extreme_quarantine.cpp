// One ball with a number that is none, or that leads to none: it alone pays for it.
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "measure/extreme_rows.h"

namespace ballpit::measure {

namespace {

constexpr std::uint32_t victim = 20;

Scene crowd() {
    Scene scene = extreme_scene("contact,restitution,walls", 2.0);
    scene.settings.restitution = 0.8;
    fill_region(scene, 64, {0.1, 0.2}, 1.0, dvec3(-1.0), dvec3(1.0));
    return scene;
}

struct Planted {
    const char* name;
    bool velocity;
    float number;
};

template <class Change>
void change_slot(Simulation& simulation, Slot slot, const Change& change) {
    auto values = read_slot<vec4>(simulation.backend(), slot);
    change(values[victim]);
    simulation.backend().write(slot, std::as_bytes(std::span(values)));
}

void plant(Simulation& simulation, const Planted& planted) {
    change_slot(simulation, planted.velocity ? Slot::velocities : Slot::positions,
                [&](vec4& value) { value.y = planted.number; });
}

// Where nobody comes within some steps; both slots are written, as for the planted number.
void put_aside(Simulation& simulation) {
    change_slot(simulation, Slot::positions, [](vec4& value) { value = vec4(1.8f, 1.8f, 1.8f, value.w); });
    change_slot(simulation, Slot::velocities, [](vec4& value) { value = vec4(0.0f, 0.0f, 0.0f, value.w); });
}

/// The same run with the ball put aside: what the others do must not depend on it.
std::uint32_t others_that_differ(Simulation& simulation, const Scene& scene, const ExtremeTrial& trial) {
    Simulation without = trial.start(scene);
    run_steps(without, 5);
    put_aside(without);
    run_steps(without, 5);
    const BallState a = simulation.raw_state();
    const BallState b = without.raw_state();
    std::uint32_t differing = 0;
    for (std::uint32_t i = 0; i < a.count(); ++i) {
        differing += i != victim && (a.positions[i] != b.positions[i] || a.velocities[i] != b.velocities[i]) ? 1 : 0;
    }
    return differing;
}

void try_number(ExtremeTrial& trial, const Planted& planted) {
    const Scene scene = crowd();
    Simulation simulation = trial.start(scene);
    run_steps(simulation, 5);
    change_slot(simulation, Slot::positions, [](vec4&) {});  // rounds a reference in double as put_aside() does
    change_slot(simulation, Slot::velocities, [](vec4&) {});
    plant(simulation, planted);
    run_steps(simulation, 5);
    trial.expect(all_finite(simulation.raw_state()), std::string(planted.name) + ": every number finite afterwards");
    trial.at_most("others changed by it", others_that_differ(simulation, scene, trial), 0.0);
}

}  // namespace

void numbers_that_are_none(ExtremeTrial& trial) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    for (const Planted& planted :
         std::array{Planted{"NaN as a place", false, nan}, Planted{"NaN as a speed", true, nan},
                    Planted{"Inf as a place", false, -infinity}, Planted{"Inf as a speed", true, infinity}}) {
        try_number(trial, planted);
    }
    Simulation counted = trial.start(crowd());
    plant(counted, {"", false, nan});
    run_steps(counted, 5);
    trial.expect_sign(counted, "quarantined");
}

void enormous_speed(ExtremeTrial& trial) {
    for (const Planted& planted : std::array{Planted{"1e30 m/s", true, 1e30f}, Planted{"-3e38 m/s", true, -3e38f},
                                             Planted{"at 1e30 m", false, 1e30f}}) {
        try_number(trial, planted);
    }
    Simulation counted = trial.start(crowd());
    plant(counted, {"", true, 1e10f});
    run_steps(counted, 5);
    trial.expect_sign(counted, "too_fast");
    trial.expect_sign(counted, "out_of_bounds");
}

}  // namespace ballpit::measure
