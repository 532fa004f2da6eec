// A sweep against what is known: errors fall as the orders say, blown-up runs are told of, and stopping keeps rows.
#include "measure/sweep.h"

#include <limits>

#include "core/scene_file.h"
#include "cpu/cpu_backend.h"
#include "measure/collision_ladder.h"
#include "measure/sweep_points.h"
#include "support/catch.h"

using namespace ballpit;
using namespace ballpit::measure;

namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

SweepBackends mirror_backends() {
    return {[] { return std::make_unique<cpu::CpuBackend<float>>(); },
            [] { return std::make_unique<cpu::CpuBackend<double>>(); }};
}

Scene shipped(const std::string& name) {
    return load_scene(std::filesystem::path(BALLPIT_SOURCE_DIR) / "assets/scenes" / (name + ".json"));
}

SweepQuestion question_of(const std::string& name, std::vector<SweepPoint> points) {
    SweepQuestion question;
    question.scene = shipped(name);
    question.settings = question.scene.settings;
    question.points = std::move(points);
    return question;
}

std::vector<SweepPoint> points_of(Integrator integrator, std::initializer_list<std::uint32_t> substeps) {
    std::vector<SweepPoint> points;
    for (const std::uint32_t n : substeps) {
        points.push_back({integrator, n, false, 1});
    }
    return points;
}

std::vector<SweepRow> run(SweepQuestion question) {
    Sweep sweep(std::move(question), mirror_backends());
    while (sweep.advance(no_limit)) {
    }
    CHECK(sweep.progress() == 1.0);
    return {sweep.rows().begin(), sweep.rows().end()};
}

}  // namespace

TEST_CASE("after one head-on hit leapfrog is within a millimetre with 12 substeps, the historical one needs thousands",
          "[sweep]") {
    const auto leapfrog = run(question_of("two_balls", points_of(Integrator::leapfrog, {12})));
    REQUIRE(leapfrog.size() == 1);
    REQUIRE(leapfrog[0].position);
    CHECK(*leapfrog[0].position < 1e-3);
    auto points = points_of(Integrator::historical, {12, 1024});
    points.push_back({Integrator::historical, 4096, true});
    const auto historical = run(question_of("two_balls", points));
    REQUIRE(historical[1].position);
    CHECK(*historical[0].position > 100.0 * *leapfrog[0].position);
    CHECK(*historical[1].position > 1e-3);
    REQUIRE(historical[2].position);
    CHECK(*historical[2].position < 1e-3);
}

TEST_CASE("more substeps are more exact only until rounding takes over, which compensated sums put off", "[sweep]") {
    auto points = points_of(Integrator::leapfrog, {15, 96, 1024, 65536});
    points.push_back({Integrator::leapfrog, 65536, true});
    const auto rows = run(question_of("two_balls", points));
    REQUIRE(rows.size() == 5);
    for (const SweepRow& row : rows) {
        REQUIRE(row.position);
    }
    CHECK(*rows[1].position < *rows[0].position);
    CHECK(*rows[3].position > 10.0 * *rows[2].position);
    CHECK(*rows[4].position < 0.01 * *rows[3].position);
}

TEST_CASE("the energy that the historical integrator makes is seen, and leapfrog's is far below", "[sweep]") {
    const auto historical = run(question_of("two_balls", points_of(Integrator::historical, {16})));
    const auto leapfrog = run(question_of("two_balls", points_of(Integrator::leapfrog, {16})));
    REQUIRE(historical[0].energy);
    REQUIRE(leapfrog[0].energy);
    // One hit in the second: e = exp(pi^2 / 4 Nc), energy e^2.
    const double nc = historical[0].substeps_a_contact;
    const double gain = std::exp(std::numbers::pi * std::numbers::pi / (2.0 * nc)) - 1.0;
    CHECK(*historical[0].energy == Approx(gain).epsilon(0.03));
    CHECK(*leapfrog[0].energy < 0.02 * *historical[0].energy);
}

TEST_CASE("errors of position fall with dt^2 after an oblique hit", "[sweep]") {
    SweepQuestion question = question_of("oblique_pair", points_of(Integrator::leapfrog, {8, 32}));
    question.seconds = 0.5;
    const auto rows = run(question);
    REQUIRE(rows[0].position);
    REQUIRE(rows[1].position);
    CHECK(std::log2(*rows[0].position / *rows[1].position) / 2.0 == Approx(2.0).margin(0.5));
    REQUIRE(rows[0].overlap);
    CHECK(*rows[0].overlap > 0.0);
    REQUIRE(rows[0].restitution);
    CHECK(*rows[1].restitution < *rows[0].restitution);
}

TEST_CASE("a run that explodes says so and has no error that could be drawn", "[sweep]") {
    SweepQuestion question = question_of("column_of_ten", points_of(Integrator::leapfrog, {1}));
    question.settings.stiffness = 1e7;
    const auto rows = run(question);
    REQUIRE(rows.size() == 1);
    CHECK_FALSE(rows[0].finite);
    CHECK_FALSE(rows[0].energy);
    CHECK_FALSE(rows[0].note.empty());
}

TEST_CASE("a run beyond the limit is broken off with its cost, and the others go on", "[sweep]") {
    SweepQuestion question = question_of("two_balls", points_of(Integrator::leapfrog, {1u << 20, 4}));
    question.limit_s = 0.2;
    const auto rows = run(question);
    REQUIRE(rows.size() == 2);
    CHECK(rows[0].ms_a_second > 200.0);
    CHECK_FALSE(rows[0].position);
    CHECK(rows[0].note.find("limit") != std::string::npos);
    CHECK(rows[1].note.empty());
}

TEST_CASE("whoever stops a sweep keeps the rows that are there, and slices change no result", "[sweep]") {
    Sweep sweep(question_of("two_balls", points_of(Integrator::leapfrog, {4, 8, 16})), mirror_backends());
    std::size_t slices = 0;
    double progress = 0.0;
    while (sweep.rows().empty()) {
        REQUIRE(sweep.advance(0.05));
        ++slices;
        progress = sweep.progress();
    }
    CHECK(slices > 10);
    CHECK(progress > 0.0);
    CHECK(progress < 1.0);
    CHECK(sweep.seconds_left());
    const auto at_once = run(question_of("two_balls", points_of(Integrator::leapfrog, {4})));
    CHECK(sweep.rows()[0].position == at_once[0].position);
    CHECK(sweep.rows()[0].energy == at_once[0].energy);
}

TEST_CASE("more balls than the reference takes: everything but positions is measured", "[sweep]") {
    SweepQuestion question = question_of("rain", points_of(Integrator::leapfrog, {2}));
    question.seconds = 0.03;
    Sweep sweep(std::move(question), mirror_backends());
    while (sweep.advance(no_limit)) {
    }
    CHECK(sweep.reference().note.find("4096") != std::string::npos);
    CHECK_FALSE(sweep.rows()[0].position);
    CHECK(sweep.rows()[0].energy);
}

TEST_CASE("a saved moment is run for as long as any other scene", "[sweep]") {
    SweepQuestion question = question_of("two_balls", points_of(Integrator::leapfrog, {12}));
    const auto fresh = run(question);
    question.scene.resume = Resume{};
    question.scene.resume->step = 1000;
    question.scene.resume->time = 50.0;
    const auto resumed = run(question);
    CHECK(resumed[0].position_at.size() == 61);
    CHECK(resumed[0].position_at == fresh[0].position_at);
    CHECK(resumed[0].energy == fresh[0].energy);
}

TEST_CASE("nothing to run is no error", "[sweep]") {
    SweepQuestion question = question_of("two_balls", points_of(Integrator::leapfrog, {4}));
    question.settings.balls = 0;
    CHECK(run(question).empty());
    CHECK(run(question_of("two_balls", {})).empty());
}

TEST_CASE("a scene without contacts has no contact to count substeps of", "[sweep]") {
    SweepQuestion question = question_of("free_fall", points_of(Integrator::symplectic_euler, {4, 8}));
    question.settings.balls = 10;
    question.seconds = 0.5;
    const auto rows = run(question);
    CHECK(rows[0].substeps_a_contact == 0.0);
    CHECK_FALSE(rows[0].restitution);
    REQUIRE(rows[1].position);
    CHECK(*rows[0].position / *rows[1].position == Approx(2.0).epsilon(0.05));
}

TEST_CASE("the choices of a sweep: every combination of what was given, else the usual set", "[sweep]") {
    Settings settings = shipped("two_balls").settings;
    const auto given =
        sweep_points(settings, {{Integrator::leapfrog, Integrator::historical}, {2, 4}, {false, true}, {1, 8}});
    CHECK(given.size() == 16);
    CHECK(given.front() == SweepPoint{Integrator::leapfrog, 2, false, 1});
    CHECK(given.back() == SweepPoint{Integrator::historical, 4, true, 8});
    const auto few = sweep_points(settings, {});
    CHECK(few.back().substeps == 65536);
    const auto many = sweep_points(shipped("rain").settings, {});
    CHECK(many.back() == SweepPoint{Integrator::leapfrog, 128, false, 8});
    CHECK(std::ranges::none_of(few, [](const SweepPoint& point) { return point.grid_reuse > 1; }));  // no grid
}

TEST_CASE("a grid is used again with cells as wide as a run before found them to be needed", "[sweep]") {
    const SweepPoint each{Integrator::leapfrog, 16, false, 1};
    const SweepPoint again{Integrator::leapfrog, 16, false, 8};
    SweepQuestion question = question_of("elastic_gas", {each, again});
    question.settings.balls = 300;
    const auto rows = run(question);
    REQUIRE(rows.size() == 2);
    CHECK(rows[0].cell_factor == 1.0);
    CHECK_FALSE(rows[0].missed);
    CHECK(rows[1].cell_factor > 1.0);
    REQUIRE(rows[1].missed);
    CHECK(*rows[1].missed == 0);
    REQUIRE(rows[0].position);
    REQUIRE(rows[1].position);
    CHECK(*rows[1].position == Approx(*rows[0].position).epsilon(0.2));  // the same contacts, in another order
    const Settings applied = with_row(question.settings, rows[1]);
    CHECK(applied.grid_reuse == 8);
    CHECK(applied.cell_factor == rows[1].cell_factor);
    CHECK(point_of(applied) == again);
}

TEST_CASE("whole substeps a contact: leapfrog errs by less than 2.1 / Nc^3, the historical one by its closed form",
          "[sweep]") {
    Sweep sweep(question_of("two_balls", points_of(Integrator::leapfrog, {4})), mirror_backends());
    const auto ladder =
        collision_ladder({shipped("two_balls").settings, sweep.probe_scene()}, mirror_backends().device);
    REQUIRE_FALSE(ladder.empty());
    for (const CollisionRung& rung : ladder) {
        const double nc = rung.substeps_a_contact;
        INFO(integrator_names.at(static_cast<std::size_t>(rung.integrator)) << ", Nc = " << nc);
        CHECK(rung.group.restitution.exact == 1.0);
        if (rung.integrator != Integrator::historical) {
            CHECK(std::abs(rung.group.restitution.mean - 1.0) <= 2.1 / (nc * nc * nc) + rung.rounding);
        } else if (nc >= 10) {  // below, the next term of the series is more than two hundredths
            CHECK(rung.group.restitution.mean - 1.0 == Approx(rung.expected - 1.0).epsilon(0.02));
        }
    }
}
