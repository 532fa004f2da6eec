// Walls in motion: where they arrive, how near they come, and what a ball feels of their velocity.
#include "core/box.h"

#include <cmath>
#include <memory>
#include <numbers>

#include "core/random.h"
#include "core/simulation.h"
#include "cpu/cpu_backend.h"
#include "support/catch.h"

using namespace ballpit;

namespace {

constexpr double pi = std::numbers::pi;

Settings walls_settings() {
    Settings settings;
    settings.laws = parse_laws("contact,restitution,walls");
    return settings;
}

Settings shaken_settings() {
    Settings settings = walls_settings();
    settings.laws.shake = true;
    settings.shake_amplitude = {0.3, 0.0, 0.1};
    settings.shake_frequency = 2.0;
    return settings;
}

double random_in(double low, double high, std::uint64_t index) {
    return std::lerp(low, high, random_unit(5, 0, index));
}

// One ball of 1 kg before the lower x wall, which moves towards it at 1 m/s; no gravity.
Simulation hit_by_wall(double restitution, double ball_speed) {
    Scene scene;
    scene.name = "wall";
    scene.half_extent = dvec3(2.0);
    scene.settings = walls_settings();
    scene.settings.restitution = restitution;
    scene.settings.stiffness = 1e5;
    scene.settings.limit_force = true;
    scene.settings.substeps = 512;
    scene.settings.walls_low = {1.0, 0.0, 0.0};
    scene.settings.wall_speed = 1.0;
    scene.balls = {{{-1.7, 0, 0}, {ball_speed, 0, 0}, 0.1, 1.0, std::nullopt}};
    scene.settings.balls = 1;
    return {scene, scene.settings, 0, std::make_unique<cpu::CpuBackend<double>>()};
}

}  // namespace

TEST_CASE("walls arrive exactly where they are wanted, and then stand", "[box]") {
    for (std::uint64_t i = 0; i < 200; ++i) {
        Settings settings = walls_settings();
        settings.walls_low = {random_in(-2, 0.4, 6 * i), random_in(-2, 0.4, 6 * i + 1), random_in(-2, 0.4, 6 * i + 2)};
        settings.walls_high = {random_in(-0.4, 2, 6 * i + 3), random_in(-0.4, 2, 6 * i + 4), 0.0};
        settings.wall_speed = random_in(0.01, 10, 6 * i + 5);
        const Box box(dvec3(1.0));
        WallShift shift;
        int substeps = 0;
        while (walls_move(shift, settings, box, 0.2)) {
            shift = advance(shift, settings, box, 0.2, 0.01);
            REQUIRE(++substeps < 30000);
        }
        CHECK(shift.low == settings.walls_low);
        CHECK(shift.high == settings.walls_high);
        const double farthest = std::max(glm::length(settings.walls_low), glm::length(settings.walls_high));
        CHECK(substeps <= farthest / (settings.wall_speed * 0.01) + 2.0);
        CHECK(advance(shift, settings, box, 0.2, 0.01) == shift);
    }
}

TEST_CASE("walls never come nearer to each other than the room that must stay", "[box]") {
    for (const double room : {0.0, 0.3, 1.9, 5.0}) {
        Settings settings = walls_settings();
        settings.walls_low = dvec3(100.0);
        settings.walls_high = dvec3(-100.0);
        settings.wall_speed = 7.0;
        const Box box(dvec3(1.0, 2.0, 3.0));
        const dvec3 least = glm::min(box.size(), dvec3(room));
        WallShift shift;
        for (int i = 0; i < 1000; ++i) {
            shift = advance(shift, settings, box, room, 0.01);
            const dvec3 size = shifted(box, shift).size();
            CAPTURE(room, i, size.x, size.y, size.z);
            REQUIRE(glm::all(glm::greaterThanEqual(size, least - 1e-12)));
        }
        CHECK_FALSE(walls_move(shift, settings, box, room));
        CHECK(glm::length(shifted(box, shift).size() - least) < 1e-12);
    }
}

TEST_CASE("a shaken box follows amplitude times sine, however long", "[box]") {
    const Settings settings = shaken_settings();
    const Box box(dvec3(1.0));
    const double dt = 1.0 / 480.0;
    WallShift shift;
    for (int i = 1; i <= 100000; ++i) {
        shift = advance(shift, settings, box, 0.2, dt);
        REQUIRE(shift.shake_phase >= 0.0);
        REQUIRE(shift.shake_phase < 2.0 * pi);
        const double expected = std::sin(2.0 * pi * settings.shake_frequency * dt * i);
        REQUIRE(std::abs(shift.shake.x - 0.3 * expected) < 1e-8);
        REQUIRE(std::abs(shift.shake.z - 0.1 * expected) < 1e-8);
        REQUIRE(shift.shake.y == 0.0);
    }
    CHECK(walls_move(shift, settings, box, 0.2));
}

TEST_CASE("the box does not jump when amplitude or frequency change, or the shaking stops", "[box]") {
    Settings settings = shaken_settings();
    const Box box(dvec3(1.0));
    const double dt = 1.0 / 480.0;
    WallShift shift;
    for (std::uint64_t i = 0; i < 5000; ++i) {
        if (i % 37 == 0) {
            settings.shake_amplitude.x = random_in(-1, 1, 3 * i);
            settings.shake_frequency = random_in(0.1, 10, 3 * i + 1);
            settings.laws.shake = random_in(0, 1, 3 * i + 2) < 0.8;
        }
        const WallShift next = advance(shift, settings, box, 0.2, dt);
        const double fastest = std::abs(settings.shake_amplitude.x) * 2.0 * pi * settings.shake_frequency;
        REQUIRE(std::abs(next.shake.x - shift.shake.x) <= fastest * dt * (1.0 + 1e-9));
        REQUIRE((settings.laws.shake || next.shake == shift.shake));
        shift = next;
    }
}

TEST_CASE("the velocity of walls is the way they come in a substep", "[box]") {
    Settings settings = shaken_settings();
    settings.walls_high = {-0.5, 0.0, 0.0};
    settings.wall_speed = 2.0;
    const Box box(dvec3(1.0));
    const double dt = 0.001;
    const WallShift next = advance({}, settings, box, 0.2, dt);
    const Walls walls = moving_walls(box, {}, next, dt);
    CHECK(walls.box == box);
    const double swing = 0.3 * std::sin(2.0 * pi * 2.0 * dt) / dt;
    CHECK(walls.lower_velocity.x == Approx(swing));
    CHECK(walls.upper_velocity.x == Approx(swing - 2.0));
    CHECK(moving_walls(box, {}, next, 0.0).upper_velocity == dvec3(0.0));
}

TEST_CASE("a moving wall throws a ball back: u - e (v - u)", "[box]") {
    // The wall has u = 1 m/s; the map of a fixed wall holds in the frame that moves with it.
    for (const double e : {1.0, 0.8, 0.4}) {
        for (const double v : {-1.5, -0.5, 0.0}) {
            Simulation simulation = hit_by_wall(e, v);
            CAPTURE(e, v);
            CHECK(simulation.features().has(Feature::moving_walls));
            for (int i = 0; i < 45; ++i) {
                simulation.step();
            }
            const double after = static_cast<double>(simulation.synchronised_state().velocities[0].x);
            CHECK(after == Approx(1.0 - e * (v - 1.0)).epsilon(2e-3));
        }
    }
}

TEST_CASE("a wall that has arrived costs nothing any longer, and a ball bounces off it as off any", "[box]") {
    Simulation simulation = hit_by_wall(0.5, 0.0);
    const std::uint64_t before = simulation.schedule_changes();
    while (simulation.features().has(Feature::moving_walls)) {
        REQUIRE(simulation.time() < 1.1);
        simulation.substep();
    }
    CHECK(simulation.schedule_changes() == before + 1);
    CHECK(simulation.box().lower.x == -1.0);
    CHECK(simulation.time() == Approx(1.0).epsilon(1e-4));
    const SubstepParams<double> params = simulation.params();
    CHECK(params.box_lower.x == -1.0);
    CHECK(params.lower_velocity == dvec3(0.0));
}

TEST_CASE("a ball is pulled as by a critically damped spring: x0 (1 + w t) exp(-w t)", "[box]") {
    Scene scene;
    scene.name = "pull";
    scene.balls = {{{1, -2, 0.5}, {0, 0, 0}, 0.1, 3.0, std::nullopt}, {{5, 5, 5}, {0, 0, 0}, 0.1, 1.0, std::nullopt}};
    scene.settings.balls = 2;
    scene.settings.laws = parse_laws("none");
    scene.settings.substeps = 256;
    scene.settings.pull = Pull{0, dvec3(0.0)};
    Simulation simulation(scene, scene.settings, 0, std::make_unique<cpu::CpuBackend<double>>());
    const double rate = simulation.params().pull_rate;
    REQUIRE(rate > 1.0);
    for (int i = 1; i <= 60; ++i) {
        simulation.step();
        const double wt = rate * simulation.time();
        const double left = (1.0 + wt) * std::exp(-wt);
        const BallState state = simulation.synchronised_state();
        CAPTURE(i);
        CHECK(static_cast<double>(state.positions[0].x) == Approx(left).margin(1e-3));
        CHECK(static_cast<double>(state.positions[0].y) == Approx(-2.0 * left).margin(2e-3));
        CHECK(state.positions[1] == vec4(5, 5, 5, 0.1f));
    }
}
