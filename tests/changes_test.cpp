// What a user does to a running scene: laws that come and go, balls that are thrown in.
#include <memory>

#include "core/simulation.h"
#include "cpu/cpu_backend.h"
#include "support/catch.h"
#include "support/input_error.h"
#include "support/law_scenes.h"

using namespace ballpit;

namespace {

Simulation running(const std::string& laws, std::uint32_t balls = 60) {
    const Scene scene = test::scene_with(laws, balls);
    Simulation simulation(scene, scene.settings, 3, std::make_unique<cpu::CpuBackend<float>>());
    for (int i = 0; i < 5; ++i) {
        simulation.step();
    }
    simulation.substep();  // in the middle of a step
    return simulation;
}

AddBalls two_balls() {
    return {{{{0.1, 0.2, 0.3}, {1, 2, 3}, 0.15, 4.0, std::nullopt}, {{-0.5, 0, 0}, {0, 0, -1}, 0.05, 0.5, 0.3}}};
}

void check_kept(const BallState& before, const BallState& after) {
    REQUIRE(after.count() >= before.count());
    for (std::size_t i = 0; i < before.count(); ++i) {
        CHECK(after.positions[i] == before.positions[i]);
        CHECK(after.velocities[i] == before.velocities[i]);
    }
}

}  // namespace

TEST_CASE("ticking a law while the scene runs keeps every ball where it is, bit for bit", "[changes]") {
    for (const char* laws : {"none", "gravity", "gravity,drag,contact,restitution,walls,diagnostics"}) {
        for (const LawInfo& law : law_table()) {
            Simulation simulation = running(laws);
            CAPTURE(laws, law.key);
            const BallState before = simulation.synchronised_state();
            const double time = simulation.time();
            Settings settings = simulation.settings();
            settings.laws.*law.member = !(settings.laws.*law.member);
            simulation.change(settings);
            CHECK(hash_state(simulation.synchronised_state()) == hash_state(before));
            CHECK(simulation.time() == Approx(time));
            simulation.step();
            settings.laws.*law.member = !(settings.laws.*law.member);
            const std::uint64_t later = hash_state(simulation.synchronised_state());
            simulation.change(settings);
            CHECK(hash_state(simulation.synchronised_state()) == later);
        }
    }
}

TEST_CASE("balls thrown in stand behind those that are there, which go on as they were", "[changes]") {
    for (const char* laws : {"gravity", "gravity,contact,restitution,walls"}) {
        Simulation simulation = running(laws);
        const BallState before = simulation.synchronised_state();
        simulation.apply(two_balls());
        const BallState after = simulation.synchronised_state();
        CAPTURE(laws);
        REQUIRE(after.count() == 62);
        check_kept(before, after);
        CHECK(after.positions[60] == vec4(0.1f, 0.2f, 0.3f, 0.15f));
        CHECK(after.velocities[60] == vec4(1, 2, 3, 4));
        CHECK(after.positions[61] == vec4(-0.5f, 0, 0, 0.05f));
        CHECK(simulation.settings().balls == 62);
        CHECK(simulation.added() == 2);
        CHECK(simulation.variety().radii);
        CHECK(simulation.features().has(Feature::unequal_masses) == simulation.settings().laws.contact);
        simulation.step();
        CHECK(simulation.raw_state().count() == 62);
    }
}

TEST_CASE("a restart takes balls that were thrown in away again", "[changes]") {
    Simulation simulation = running("gravity,contact,walls");
    Simulation untouched = running("gravity,contact,walls");
    simulation.apply(two_balls());
    simulation.step();
    simulation.apply(two_balls());
    CHECK(simulation.added() == 4);
    simulation.restart(3);
    untouched.restart(3);
    CHECK(simulation.settings().balls == 60);
    CHECK(simulation.added() == 0);
    CHECK(hash_state(simulation.raw_state()) == hash_state(untouched.raw_state()));
    CHECK_FALSE(simulation.variety().radii);
}

TEST_CASE("back before balls were thrown in everything is as it was", "[changes]") {
    Simulation simulation = running("gravity,contact,restitution,walls");
    const Features features = simulation.features();
    const Checkpoint before = simulation.checkpoint();
    simulation.step();
    const std::uint64_t ahead = hash_state(simulation.raw_state());
    simulation.restore(before);
    simulation.apply(two_balls());
    Settings settings = simulation.settings();
    settings.walls_low = {0.1, 0.0, 0.0};
    settings.laws.ball_restitution = true;
    simulation.change(settings);
    simulation.step();
    CHECK(simulation.features() != features);
    simulation.restore(before);
    CHECK(simulation.features() == features);
    CHECK_FALSE(simulation.variety().radii);
    CHECK(simulation.restitutions().empty());
    CHECK(simulation.added() == 0);
    CHECK(simulation.box() == simulation.scene_box());
    simulation.step();
    CHECK(hash_state(simulation.raw_state()) == ahead);
}

TEST_CASE("fewer balls take those away first that were thrown in", "[changes]") {
    Simulation simulation = running("gravity,contact,walls");
    simulation.apply(two_balls());
    Settings settings = simulation.settings();
    settings.balls = 61;
    simulation.change(settings);
    CHECK(simulation.added() == 1);
    settings.balls = 10;
    simulation.change(settings);
    CHECK(simulation.added() == 0);
    CHECK(simulation.raw_state().count() == 10);
}

TEST_CASE("nothing thrown in is no change", "[changes]") {
    Simulation simulation = running("gravity,contact,walls");
    const BallState before = simulation.raw_state();
    const std::uint64_t schedules = simulation.schedule_changes();
    simulation.apply(AddBalls{});
    CHECK(hash_state(simulation.raw_state()) == hash_state(before));
    CHECK(simulation.raw_state().velocity_lag == before.velocity_lag);
    CHECK(simulation.schedule_changes() == schedules);
}

TEST_CASE("more balls than there may be are refused, and the scene runs on", "[changes]") {
    Simulation simulation = running("gravity");
    const std::uint64_t before = hash_state(simulation.raw_state());
    const AddBalls many{std::vector<BallSpec>(maximum_balls)};
    const std::string sentence = test::complaint_of([&] { simulation.apply(many); });
    CHECK(sentence.find(std::to_string(maximum_balls + 60)) != std::string::npos);
    CHECK(sentence.find(std::to_string(maximum_balls) + " are possible") != std::string::npos);
    CHECK(hash_state(simulation.raw_state()) == before);
    CHECK(simulation.settings().balls == 60);
}

TEST_CASE("a pulled ball that is not there pulls nothing", "[changes]") {
    Simulation simulation = running("gravity");
    Settings settings = simulation.settings();
    settings.pull = Pull{60, dvec3(0.0)};
    simulation.change(settings);
    CHECK_FALSE(simulation.features().has(Feature::pull));
    settings.pull->ball = 59;
    simulation.change(settings);
    CHECK(simulation.features().has(Feature::pull));
    settings.balls = 20;
    simulation.change(settings);
    CHECK_FALSE(simulation.features().has(Feature::pull));
    simulation.step();
}

TEST_CASE("laws and pulls print and parse to the same value", "[changes]") {
    for (unsigned bits = 0; bits < 1u << law_count; ++bits) {
        Laws laws;
        for (std::size_t i = 0; i < law_count; ++i) {
            laws.*law_table()[i].member = (bits >> i & 1u) != 0;
        }
        REQUIRE(parse_laws(laws_text(laws)) == laws);
    }
    for (const char* bad : {"", ",", "gravity,", "gravity,,drag", "Gravity", "none,gravity", "gravity drag"}) {
        CAPTURE(bad);
        CHECK(test::complaint_of([&] { parse_laws(bad); }).find("expected none, or some of gravity") !=
              std::string::npos);
    }
    const SettingInfo& info = *find_setting("pull");
    for (const Pull& pull : {Pull{0, dvec3(0.0)}, Pull{4000000000u, {-1e4, 0.1, 1e-17}}}) {
        Settings settings;
        settings.pull = pull;
        Settings parsed;
        assign_setting(parsed, "pull", setting_text(info, settings));
        CHECK(parsed.pull == settings.pull);
    }
    for (const char* bad : {"", "1", "1,2,3", "-1,0,0,0", "1,0,0,nan", "1,0,0,0,0", "1,0,0,1e9"}) {
        Settings settings;
        CAPTURE(bad);
        CHECK_THROWS_AS(assign_setting(settings, "pull", bad), InputError);
        CHECK_FALSE(settings.pull);
    }
}
