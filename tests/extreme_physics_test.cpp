// The physics of the extremes on the mirror, and the table of what is counted and warned of.
#include <set>

#include "core/extremes.h"
#include "core/scene_file.h"
#include "core/scene_writer.h"
#include "core/stepper.h"
#include "cpu/cpu_backend.h"
#include "measure/warnings.h"
#include "support/catch.h"
#include "support/extreme_contract.h"
#include "support/law_scenes.h"

using namespace ballpit;

namespace {

std::unique_ptr<Backend> mirror() { return std::make_unique<cpu::CpuBackend<float>>(); }

ExtremeNumbers warnings_with(const std::string& laws, const std::string& key, const std::string& value) {
    Scene scene = test::scene_with(laws, 60);
    assign_setting(scene.settings, key, value);
    const Simulation simulation(scene, scene.settings, 3, mirror());
    return measure::warnings_of(simulation, nullptr);
}

}  // namespace

TEST_CASE("the mirror quarantines balls that are no number", "[extreme]") {
    test::quarantine_leaves_the_others_alone(mirror);
}
TEST_CASE("the mirror's walls have a cap", "[extreme]") { test::walls_push_no_harder_than_their_cap(mirror); }
TEST_CASE("the mirror counts coincident balls", "[extreme]") { test::coincident_balls_are_counted(mirror); }
TEST_CASE("the mirror counts balls that are too fast", "[extreme]") { test::too_fast_balls_are_counted(mirror); }
TEST_CASE("no time changes no bit on the mirror", "[extreme]") { test::no_time_changes_no_bit(mirror); }
TEST_CASE("the mirror's semi-implicit dashpots hold", "[extreme]") { test::semi_implicit_dashpots_hold(mirror); }
TEST_CASE("the mirror relaxes overlaps", "[extreme]") { test::relaxing_parts_balls(mirror); }

TEST_CASE("every extreme has a key of its own", "[extreme]") {
    std::set<std::string_view> keys;
    for (const ExtremeInfo& info : extreme_table()) {
        CHECK(keys.insert(info.key).second);
        CHECK(info.about.ends_with("."));
    }
    Status status{};
    status.bits = STATUS_TOO_FAST;  // its sum has run over
    CHECK(counted_extremes(status)[Extreme::too_fast] == 1.0);
    CHECK(counted_extremes(status)[Extreme::coincident] == 0.0);
}

TEST_CASE("each warning comes with its number, and only past its limit", "[extreme]") {
    const std::string pile = "gravity,contact,restitution,walls";
    for (const ExtremeInfo& info : extreme_table()) {
        CAPTURE(info.key);
        CHECK(warnings_with(pile, "substeps", "16")[info.extreme] == 0.0);
    }
    CHECK(warnings_with(pile, "stiffness", "1e8")[Extreme::unstable_dt] > 1.0);
    CHECK(warnings_with(pile, "stiffness", "1e8")[Extreme::few_substeps_per_contact] < 1.0);
    CHECK(warnings_with(pile, "stiffness", "1e8")[Extreme::float_floor] > 0.01);
    CHECK(warnings_with(pile, "stiffness", "0")[Extreme::unstable_dt] == 0.0);
    CHECK(warnings_with(pile, "dt", "1e-7")[Extreme::tiny_dt] > 0.01);
    CHECK(warnings_with(pile, "dt", "0")[Extreme::tiny_dt] == 0.0);
    CHECK(warnings_with(pile, "cell_factor", "0.5")[Extreme::cell_too_small] == Approx(0.5).epsilon(1e-4));
    CHECK(warnings_with("contact,walls", "integrator", "historical")[Extreme::numerical_heating] > 0.0);
}

TEST_CASE("a dashpot beyond its limit is told, and the semi-implicit one is not", "[extreme]") {
    Scene scene = test::scene_with("gravity,contact,restitution,walls", 60);
    scene.settings.restitution = 0.05;
    scene.settings.substeps = 4;
    scene.settings.stiffness = 2e4;
    const Simulation exact(scene, scene.settings, 3, mirror());
    CHECK(measure::warnings_of(exact, nullptr)[Extreme::explicit_dashpot_limit] > 1.0);
    CHECK(measure::warnings_of(exact, nullptr)[Extreme::unstable_dt] > 1.0);
    scene.settings.dashpot = DashpotMethod::semi_implicit;
    const Simulation held(scene, scene.settings, 3, mirror());
    CHECK(measure::warnings_of(held, nullptr)[Extreme::explicit_dashpot_limit] == 0.0);
    CHECK(measure::warnings_of(held, nullptr)[Extreme::unstable_dt] == 0.0);
}

TEST_CASE("deep overlaps at the start are told in joules, shallow ones are not", "[extreme]") {
    Scene scene = test::scene_with("contact", 2);
    scene.fill.reset();
    scene.balls = {{dvec3(0.0), dvec3(0.0), 0.1, 1.0, std::nullopt},
                   {{0.15, 0, 0}, dvec3(0.0), 0.1, 1.0, std::nullopt}};
    const auto stored = [&] {
        Simulation simulation(scene, scene.settings, 3, mirror());
        return measure::stored_in_overlaps(simulation.raw_state(), simulation.settings(), simulation.features(),
                                           simulation.box());
    };
    CHECK(stored() == Approx(0.5 * 2000.0 * 0.05 * 0.05).epsilon(1e-5));
    scene.balls[1].position.x = 0.195;
    CHECK(stored() == 0.0);
}

TEST_CASE("a ball in quarantine is saved, comes back in it, and is free without the law", "[extreme]") {
    Scene scene = test::scene_with("gravity,contact,restitution,walls,diagnostics", 20);
    Simulation simulation(scene, scene.settings, 3, mirror());
    BallState state = simulation.raw_state();
    state.velocities[5].x = std::numeric_limits<float>::quiet_NaN();
    simulation.backend().write(Slot::velocities, std::as_bytes(std::span(state.velocities)));
    simulation.step();
    const BallState held = simulation.raw_state();
    REQUIRE(held.positions[5].w < 0.0f);
    const Scene saved = parse_scene(scene_text(scene_of_moment(simulation)), "saved");
    Simulation resumed(saved, saved.settings, 3, mirror());
    CHECK(hash_state(resumed.raw_state()) == hash_state(held));
    Settings free = simulation.settings();
    free.laws.diagnostics = false;
    simulation.change(free);
    CHECK(simulation.raw_state().positions[5].w > 0.0f);
    CHECK(vec3(simulation.raw_state().velocities[5]) == vec3(0.0f));
}

TEST_CASE("counts survive a change, go back with stepping back, and restart with the scene", "[extreme]") {
    Scene scene = test::scene_with("contact,restitution,diagnostics", 2);
    scene.fill.reset();
    scene.balls = {{dvec3(0.0), dvec3(0.0), 0.1, 1.0, std::nullopt}, {dvec3(0.0), dvec3(0.0), 0.1, 1.0, std::nullopt}};
    Simulation simulation(scene, scene.settings, 3, mirror());
    Stepper stepper(simulation, 1u << 20);
    const auto coincident = [&] { return read_slot<Status>(simulation.backend(), Slot::status).front().coincident; };
    stepper.forward(StepUnit::step);
    CHECK(coincident() == 1);
    Settings other = simulation.settings();
    other.integrator = Integrator::symplectic_euler;
    stepper.change(other);
    CHECK(coincident() == 1);
    stepper.change(Relax{});
    const auto hash = hash_state(simulation.raw_state());
    stepper.forward(StepUnit::step);
    stepper.back(StepUnit::step);
    CHECK(hash_state(simulation.raw_state()) == hash);
    CHECK(coincident() == 1);
    simulation.restart(3);
    CHECK(coincident() == 0);
}
