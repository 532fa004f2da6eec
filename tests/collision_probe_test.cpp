// The probe of single collisions on the mirror: what it finds, in scenes of every kind.
#include "measure/collision_probe.h"

#include <cmath>
#include <numbers>

#include "cpu/cpu_backend.h"
#include "support/catch.h"
#include "support/probe_contract.h"
#include "support/scenes.h"

using namespace ballpit;
using measure::ProbeGroup;
using measure::ProbeQuestion;
using measure::ProbeResult;

namespace {

ProbeResult probe(const ProbeQuestion& question) {
    cpu::CpuBackend<float> backend;
    return measure::run_probe(backend, question);
}

void check_same(const ProbeResult& a, const ProbeResult& b) {
    REQUIRE(a.groups.size() == b.groups.size());
    for (std::size_t i = 0; i < a.groups.size(); ++i) {
        CAPTURE(i);
        CHECK(a.groups[i].restitution.mean == b.groups[i].restitution.mean);
        CHECK(a.groups[i].restitution.worst == b.groups[i].restitution.worst);
        CHECK(a.groups[i].overlap.mean == b.groups[i].overlap.mean);
        CHECK(a.groups[i].duration.mean == b.groups[i].duration.mean);
    }
}

}  // namespace

TEST_CASE("the probe finds the third order of elastic collisions", "[probe]") {
    cpu::CpuBackend<float> backend;
    test::probe_finds_elastic_errors(backend);
}

TEST_CASE("the probe finds what the historical integrator adds", "[probe]") {
    cpu::CpuBackend<float> backend;
    test::probe_finds_historical_gain(backend);
}

TEST_CASE("the probe finds the bias and the spread of damped collisions", "[probe]") {
    cpu::CpuBackend<float> backend;
    test::probe_finds_damped_restitution(backend);
    CHECK(test::damped_mean_is_right(backend));
}

TEST_CASE("far from the origin the probe sees the floor of floats", "[probe]") {
    ProbeQuestion question = test::canonical_question(true, 512.0);
    const double near = probe(question).restitution_error();
    question.scene.distance = 1000.0;
    const double far = probe(question).restitution_error();
    CHECK(near < 2e-3);
    CHECK(far > 5.0 * near);
    question.scene.distance = 1e6;  // a substep moves a ball by less than the next float: it never arrives
    const ProbeResult lost = probe(question);
    CHECK(lost.unending() == 2 * measure::probe_phases);
    CHECK(lost.restitution_error() > 1.0);
}

TEST_CASE("laws that would disturb a collision change no bit of the probe", "[probe]") {
    ProbeQuestion question = test::damped_question(0.1, true, 12.0);
    question.settings.laws.contact = true;
    question.settings.balls = 5;
    const ProbeResult plain = probe(question);
    REQUIRE(plain.groups.size() == 4);
    ProbeQuestion laden = question;
    laden.settings.laws.gravity = laden.settings.laws.drag = true;
    laden.settings.drag = 3.0;
    laden.settings.pull = Pull{0, dvec3(0.3)};
    laden.scene.walls_move = true;
    check_same(probe(laden), plain);
    laden.scene.variety.radii = laden.scene.variety.masses = laden.scene.variety.restitutions = true;
    check_same(probe(laden), plain);
    laden.settings.neighbours = NeighbourSearch::brute_force;
    laden.settings.cell_factor = 0.25;
    check_same(probe(laden), plain);
}

TEST_CASE("a probe in slices is the same probe, and as small for a long contact", "[probe]") {
    const ProbeQuestion question = test::canonical_question(false, 400.0);
    cpu::CpuBackend<float> backend;
    measure::CollisionProbe sliced(backend, question);
    std::uint32_t calls = 0;
    while (!sliced.advance(7)) {
        REQUIRE(++calls < 1000);
    }
    CHECK(calls > 80);
    CHECK(sliced.substeps_run() == sliced.substeps_to_run());
    CHECK(sliced.advance(7));
    check_same(sliced.result(), probe(question));
}

TEST_CASE("a probe says why there is nothing to probe", "[probe]") {
    ProbeQuestion question = test::canonical_question(true, 8.0);
    CHECK(probe(question).nothing.empty());
    question.settings.laws.walls = false;
    CHECK(probe(question).nothing.find("nothing touches") == 0);
    question = test::canonical_question(true, 8.0);
    question.settings.stiffness = 0.0;
    CHECK(probe(question).nothing.find("without stiffness") != std::string::npos);
    question = test::canonical_question(true, 8.0);
    question.settings.dt = 0.0;
    CHECK(probe(question).nothing.find("0 s") != std::string::npos);
    question = test::canonical_question(true, 8.0);
    question.scene.radius = 0.0;
    CHECK(probe(question).nothing == "there are no balls");
    CHECK(probe(test::canonical_question(true, 1e6)).nothing.find("not run") != std::string::npos);
}

TEST_CASE("balls that pass through each other are told from those that bounce", "[probe]") {
    ProbeQuestion question = test::canonical_question(false, 16.0);
    question.scene.largest_speed = 35.0;  // beyond D sqrt(k / mu) = 28.3 m/s
    const ProbeResult result = probe(question);
    CHECK(result.groups.at(0).unending == 0);
    CHECK(result.groups.at(1).unending == measure::probe_phases);
    CHECK(result.softness() > 1.0);
}

TEST_CASE("every shipped scene can be probed", "[probe]") {
    for (const std::string_view name : test::shipped_scene_names) {
        CAPTURE(name);
        const Scene scene = test::shipped_scene(name);
        const ProbeQuestion question = test::question_of(scene, scene.settings.balls);
        const ProbeResult result = probe(question);
        const std::size_t kinds = (scene.settings.laws.contact ? 1 : 0) + (scene.settings.laws.walls ? 1 : 0);
        CHECK(result.groups.size() == 2 * kinds);
        CHECK(result.nothing.empty() == (kinds != 0));
        CHECK(question.scene.largest_speed >= question.scene.typical_speed);
        for (const ProbeGroup& group : result.groups) {
            CAPTURE(group.wall, group.speed, group.overlap.exact, group.restitution.worst);
            CHECK(group.speed > 0.0);
            const double moved = 0.5 * group.speed * scene.settings.dt / scene.settings.substeps;
            const bool floats_end = moved < 2.0 * 1.2e-7 * question.scene.distance;  // the chain's millimetres a second
            CHECK((group.unending == 0 || group.overlap.exact > 0.9 || floats_end));
        }
    }
}
