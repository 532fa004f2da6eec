// A moment saved as a scene file goes on bit for bit.
#include "core/scene_writer.h"

#include <cmath>
#include <functional>
#include <memory>

#include "core/scene_file.h"
#include "cpu/cpu_backend.h"
#include "support/catch.h"
#include "support/input_error.h"

using namespace ballpit;

namespace {

constexpr const char* everything = R"({
  "name": "Everything \"at\" once, ä", "about": "Two lines\nof it.",
  "box": { "half_extent": [1.1, 1.3, 1.7], "reference_count": 40 },
  "laws": { "gravity": [0, 0.1, -9.8], "drag": 0.3, "contact": { "stiffness": 3000, "restitution": 0.7 }, "walls": true },
  "time": { "dt": 0.016666667, "substeps": 5, "integrator": "leapfrog" },
  "balls": [ { "position": [-0.5, 0.1, 0.2], "velocity": [3, 0.1, -0.7], "radius": 0.11, "mass": 3.3, "restitution": 0.2 },
             { "position": [0.5, -0.1, 0.2], "radius": 0.07, "mass": 0.1 } ],
  "fill": { "count": 58, "radius": [0.05, 0.11], "speed": 2.0, "region": [[-1, -1, -1], [1, 1, 1]], "seed": 5 }
})";

std::uint64_t hash_of(Simulation& simulation) { return hash_state(simulation.raw_state()); }

Simulation start(const Scene& scene) {
    const std::uint64_t seed = scene.fill ? scene.fill->seed : 0;
    return {scene, scene.settings, seed, std::make_unique<cpu::CpuBackend<float>>()};
}

// Runs, saves, runs on; loads and runs the same: both must end in the same bytes.
void expect_same_bytes(const std::string& scene, const std::function<void(Simulation&)>& change,
                       int substeps_more = 0) {
    Simulation first = start(parse_scene(scene, "scene"));
    change(first);
    for (int i = 0; i < 50; ++i) {
        first.step();
    }
    for (int i = 0; i < substeps_more; ++i) {
        first.substep();
    }
    const std::string saved = scene_text(scene_of_moment(first));
    Simulation second = start(parse_scene(saved, "saved"));
    CHECK(hash_of(second) == hash_of(first));
    CHECK(second.step_count() == first.step_count());
    CHECK(second.substep_in_step() == first.substep_in_step());
    CHECK(second.time() == first.time());
    CHECK(second.velocity_lag() == first.velocity_lag());
    CHECK(second.backend().read(Slot::compensations) == first.backend().read(Slot::compensations));
    const std::uint64_t at_saving = hash_of(first);
    for (int i = 0; i < 50; ++i) {
        first.step();
        second.step();
    }
    CHECK(hash_of(second) == hash_of(first));
    CHECK(hash_of(first) != at_saving);
    CHECK(second.time() == Approx(first.time()));
}

}  // namespace

TEST_CASE("a scene written and read again is the same scene", "[keep]") {
    const Scene scene = parse_scene(everything, "scene");
    const std::string text = scene_text(scene);
    const Scene again = parse_scene(text, "again");
    CHECK(again.name == scene.name);
    CHECK(again.about == scene.about);
    CHECK(again.half_extent == scene.half_extent);
    CHECK(again.reference_count == scene.reference_count);
    CHECK(again.settings == scene.settings);
    REQUIRE(again.balls.size() == scene.balls.size());
    CHECK(again.balls[0].velocity == scene.balls[0].velocity);
    CHECK(again.balls[0].restitution == scene.balls[0].restitution);
    CHECK_FALSE(again.balls[1].restitution);
    REQUIRE(again.fill);
    CHECK(again.fill->region == scene.fill->region);
    CHECK_FALSE(again.resume);
    CHECK(scene_text(again) == text);
}

TEST_CASE("a saved moment goes on with the same bytes", "[keep]") {
    expect_same_bytes(everything, [](Simulation&) {});
}

TEST_CASE("a moment within a step goes on with the same bytes", "[keep]") {
    expect_same_bytes(
        everything, [](Simulation&) {}, 3);
}

TEST_CASE("whatever was changed before it was saved", "[keep]") {
    const auto with = [](const std::function<void(Settings&)>& edit) {
        return [edit](Simulation& simulation) {
            Settings settings = simulation.settings();
            edit(settings);
            simulation.change(settings);
        };
    };
    SECTION("fewer balls") {
        expect_same_bytes(everything, with([](Settings& s) { s.balls = 31; }));
    }
    SECTION("more balls in a wider box") {
        expect_same_bytes(everything, with([](Settings& s) { s.balls = 90; }));
    }
    SECTION("no restitution") {
        expect_same_bytes(everything, with([](Settings& s) { s.laws.restitution = false; }));
    }
    SECTION("walls alone") {
        expect_same_bytes(everything, with([](Settings& s) { s.laws.contact = false; }));
    }
    SECTION("no laws") {
        expect_same_bytes(everything, with([](Settings& s) { s.laws = Laws{}; }));
    }
    SECTION("diagnostics off") {
        expect_same_bytes(everything, with([](Settings& s) { s.laws.diagnostics = false; }));
    }
    SECTION("how it is computed") {
        expect_same_bytes(everything, with([](Settings& s) {
                              s.sort = SortMethod::bitonic;
                              s.cell_factor = 0.6;
                              s.grid_reuse = 3;
                              s.integrator = Integrator::velocity_verlet;
                          }));
    }
    SECTION("brute force") {
        expect_same_bytes(everything, with([](Settings& s) { s.neighbours = NeighbourSearch::brute_force; }));
    }
    SECTION("walls on their way") {
        expect_same_bytes(everything, with([](Settings& s) {
                              s.walls_low = {0.1, 0.0, 0.3};
                              s.walls_high = {0.0, -0.2, 0.5};
                              s.wall_speed = 0.2;
                          }));
    }
    SECTION("a box that is being shaken") {
        expect_same_bytes(everything, with([](Settings& s) {
                              s.laws.shake = true;
                              s.shake_amplitude = {0.03, 0.0, 0.1};
                              s.shake_frequency = 1.7;
                          }));
    }
    SECTION("sums are compensated") {
        expect_same_bytes(everything, with([](Settings& s) { s.laws.compensated = true; }));
    }
    SECTION("sums are compensated, in place") {
        expect_same_bytes(everything, with([](Settings& s) {
                              s.laws.compensated = true;
                              s.laws.contact = false;
                          }));
    }
    SECTION("balls thrown in") {
        expect_same_bytes(everything, [](Simulation& simulation) {
            simulation.add({{BallSpec{{0.0, 0.0, 1.0}, {0.0, 0.0, -20.0}, 0.2, 40.0, {}}}});
        });
    }
}

TEST_CASE("a saved moment still can give more balls", "[keep]") {
    Simulation first = start(parse_scene(everything, "scene"));
    first.step();
    const Scene saved = parse_scene(scene_text(scene_of_moment(first)), "saved");
    CHECK(saved.settings.balls == 60);
    Simulation second = start(saved);
    Settings settings = saved.settings;
    settings.balls = 70;
    second.change(settings);
    CHECK(second.raw_state().count() == 70);
}

TEST_CASE("numbers keep every bit", "[keep]") {
    Scene scene = parse_scene(everything, "scene");
    const float tiny = std::nextafter(0.0f, 1.0f);
    scene.balls.resize(1);
    scene.balls[0].position = {-0.0, 16777216.0 / 16777217.0, 0.1f};
    scene.balls[0].velocity = {tiny, std::nextafter(1.0f, 2.0f), -1.0e-20f};
    const BallSpec ball = parse_scene(scene_text(scene), "scene").balls[0];
    CHECK(std::signbit(ball.position.x));
    CHECK(ball.position.y == scene.balls[0].position.y);
    CHECK(static_cast<float>(ball.position.z) == 0.1f);
    CHECK(static_cast<float>(ball.velocity.x) == tiny);
    CHECK(static_cast<float>(ball.velocity.y) == std::nextafter(1.0f, 2.0f));
    CHECK(static_cast<float>(ball.velocity.z) == -1.0e-20f);
    CHECK(scene_text(scene).find("\"position\": [-0.0, 0.99999994") != std::string::npos);
    CHECK(scene_text(scene).find(", 0.1]") != std::string::npos);
}

TEST_CASE("a state that is no number is not saved", "[keep]") {
    Simulation simulation = start(parse_scene(everything, "scene"));
    auto positions = read_slot<vec4>(simulation.backend(), Slot::positions);
    positions[7].y = std::nanf("");
    simulation.backend().write(Slot::positions, std::as_bytes(std::span(positions)));
    CHECK(test::complaint_of([&] { scene_of_moment(simulation); }) ==
          "the scene cannot be saved: ball 7 has a position or velocity that is no number");
}

TEST_CASE("what is saved can be loaded, whatever the balls have come to", "[keep]") {
    // The largest ball of the densest fill, the smallest of the lightest, and no ball at all.
    for (const char* fill : {R"({"count": 3, "radius": [1e4, 1e4], "density": 1e6})",
                             R"({"count": 3, "radius": [1e-3, 1e-3], "density": 1e-3})", "none"}) {
        CAPTURE(fill);
        const bool none = std::string(fill) == "none";
        Simulation simulation =
            start(parse_scene(R"({"name": "N", "box": {"half_extent": [1e4, 1e4, 1e4]}, )" +
                                  (none ? std::string(R"("balls": [{"position": [0, 0, 0], "radius": 1, "mass": 1}])")
                                        : R"("fill": )" + std::string(fill)) +
                                  "}",
                              "scene"));
        if (none) {
            Settings settings = simulation.settings();
            settings.balls = 0;
            simulation.change(settings);
        }
        Simulation again = start(parse_scene(scene_text(scene_of_moment(simulation)), "saved"));
        CHECK(again.settings().balls == simulation.settings().balls);
        CHECK(hash_of(again) == hash_of(simulation));
    }
}

TEST_CASE("a state that no scene file may hold is not saved", "[keep]") {
    Simulation simulation = start(parse_scene(everything, "scene"));
    auto velocities = read_slot<vec4>(simulation.backend(), Slot::velocities);
    velocities[7].z = -2e30f;
    simulation.backend().write(Slot::velocities, std::as_bytes(std::span(velocities)));
    CHECK(test::complaint_of([&] { scene_of_moment(simulation); }) ==
          "the scene cannot be saved: ball 7 has a position or velocity beyond 1e+30");
}

TEST_CASE("the scene as it is set is the one that starts with these settings", "[keep]") {
    Simulation simulation = start(parse_scene(everything, "scene"));
    Settings settings = simulation.settings();
    settings.drag = 0.75;
    settings.balls = 41;
    simulation.change(settings);
    simulation.step();
    AddBalls added;
    added.balls.push_back({dvec3(0.0), dvec3(0.0), 0.1, 1.0, {}, {}, false});
    simulation.apply(added);
    simulation.restart(9);
    const Scene again = parse_scene(scene_text(scene_as_set(simulation)), "again");
    CHECK(again.settings.drag == 0.75);
    CHECK(again.settings.balls == 41);
    CHECK(again.balls.size() == 2);
    CHECK_FALSE(again.resume);
    Simulation second = start(again);
    CHECK(hash_of(second) == hash_of(simulation));
    settings.balls = 1;  // fewer than the list has
    simulation.change(settings);
    CHECK(scene_as_set(simulation).settings.balls == 1);
    CHECK(parse_scene(scene_text(scene_as_set(simulation)), "again").settings.balls == 1);
}
