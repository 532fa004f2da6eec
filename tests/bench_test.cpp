// Rows of `ballpit bench`: measured on the mirror, and told without what cannot be true.
#include "app/bench_limits.h"
#include "app/bench_report.h"
#include "app/bench_run.h"
#include "cpu/cpu_backend.h"
#include "support/catch.h"
#include "support/input_error.h"
#include "support/scenes.h"

using namespace ballpit;

namespace {

Simulation settled_pile(std::uint32_t balls) {
    const Scene scene = test::shipped_scene("bench_pile");
    Settings settings = scene.settings;
    settings.balls = balls;
    return {app::lowered(scene, balls), settings, test::seed_of(scene), std::make_unique<cpu::CpuBackend<float>>()};
}

measure::DeviceLimits generous() {
    measure::DeviceLimits limits;
    limits.copies = {{1u << 20, 1e6}};
    return limits;
}

std::size_t fields(const std::string& line) {
    std::size_t count = 1;
    bool quoted = false;
    for (const char c : line) {
        quoted = quoted != (c == '"');
        count += c == ',' && !quoted ? 1 : 0;
    }
    return count;
}

}  // namespace

TEST_CASE("the bench pile comes to rest with the neighbours that it is meant to have", "[bench]") {
    for (const std::uint32_t balls : {1024u, 4096u}) {
        Simulation simulation = settled_pile(balls);
        const app::Settling settling = app::settle(simulation, 60.0);
        CAPTURE(balls, settling.steps, settling.kinetic);
        CHECK(settling.at_rest);
        const auto positions = read_slot<vec4>(simulation.backend(), Slot::positions);
        Grid narrow = simulation.schedule().grid;  // cells of a diameter, however many a grid may have
        narrow.cell_width = 0.2;
        narrow.cells = uvec3(glm::ceil(simulation.box().size() / 0.2));
        const measure::Crowding crowding = measure::crowding_of(positions, narrow);
        CHECK(crowding.contacts == Approx(7.0).margin(0.8));
        CHECK(crowding.candidates == Approx(26.5).margin(1.5));
    }
}

TEST_CASE("a lowered fill lies on the floor of its region and stays in it", "[bench]") {
    const Scene scene = test::shipped_scene("bench_pile");
    const Scene low = app::lowered(scene, 100000);
    CHECK(low.fill->region[0] == scene.fill->region[0]);
    CHECK(low.fill->region[1].z < scene.fill->region[0].z + 4.0);
    CHECK(make_world(low, 4096, 1).overlapping == 0);
    const Scene one_cell = test::shipped_scene("one_cell");  // fuller than a lowered fill would be
    CHECK(app::lowered(one_cell, 1000).fill->region[1] == one_cell.fill->region[1]);
    const Scene listed = test::shipped_scene("two_balls");
    CHECK_FALSE(app::lowered(listed, 2).fill);
}

TEST_CASE("what is asked to settle without gravity is refused", "[bench]") {
    const Scene scene = test::shipped_scene("elastic_gas");
    Simulation simulation(scene, scene.settings, 1, std::make_unique<cpu::CpuBackend<float>>());
    CHECK(test::complaint_of([&] { app::settle(simulation, 1.0); }).find("gravity") != std::string::npos);
}

TEST_CASE("rows of one state have one hash, whatever sorts", "[bench]") {
    Simulation simulation = settled_pile(500);
    const Checkpoint start = simulation.checkpoint();
    Settings settings = simulation.settings();
    app::BenchPlan plan;
    plan.steps = 3;
    plan.dispatches = true;
    std::vector<std::uint64_t> hashes;
    for (std::size_t sort = 0; sort < sort_names.size(); ++sort) {
        settings.sort = static_cast<SortMethod>(sort);
        const app::BenchRow row = app::measure_row(simulation, start, settings, plan, generous());
        hashes.push_back(row.hash);
        CHECK(row.sort == sort_names[sort]);
        CHECK(row.substep_ms.size() == 3);
        CHECK(row.stage_ms[0].size() == std::size_t{3} * settings.substeps);
        CHECK(row.dispatches.size() == simulation.schedule().dispatches.size());
        CHECK(row.dispatches.back().ms.size() == 3);
        CHECK(row.possible());
        CHECK(row.lost_times == 0);
        CHECK(row.stages_wall_ms > 0.0);
    }
    CHECK(hashes.front() == hashes.back());
}

TEST_CASE("a number that cannot be true is no result", "[bench]") {
    Simulation simulation = settled_pile(500);
    const Checkpoint start = simulation.checkpoint();
    app::BenchPlan plan;
    plan.steps = 2;
    measure::DeviceLimits limits;
    limits.copies = {{1u << 20, 1e-9}};  // a device that moves a byte a second
    const app::BenchRow row = app::measure_row(simulation, start, simulation.settings(), plan, limits);
    CHECK_FALSE(row.possible());
    const app::Json json = app::bench_row_json(row, limits);
    CHECK(json["ms_per_substep"].is_null());
    CHECK(json["stages"]["collide"].is_null());
    CHECK(json["impossible"]["collide"].get<std::string>().find("GB/s") != std::string::npos);
    std::ostringstream line;
    app::print_bench_row(line, row, limits);
    CHECK(line.str().find("impossible: substep") != std::string::npos);
    const app::ReportOrigin origin{{{"device", "d"}, {"driver", "e"}}, "ballpit bench --balls 1,2", "today"};
    std::istringstream csv(app::bench_csv(std::vector{row}, limits, origin));
    std::string header;
    std::string numbers;
    std::getline(csv, header);
    std::getline(csv, numbers);
    CHECK(fields(header) == fields(numbers));
    CHECK(numbers.find(",1,0,,") != std::string::npos);  // grid_reuse, missed, and no ms_per_substep
}

TEST_CASE("a picture is told of by its passes", "[bench]") {
    app::BenchRow row;
    row.frames.emplace();
    row.frames->wall_ms = 10.0;
    row.frames->pass_ms = {app::Sample{6.0}, app::Sample{1.0}, app::Sample{2.0}, app::Sample{4.0, 5.0, 3.0},
                           app::Sample{0.5}};
    const measure::DeviceLimits limits;
    const app::Json passes = app::bench_row_json(row, limits)["frames"]["passes"];
    CHECK(passes.size() == view::pass_count);
    CHECK(passes["surroundings"] == 2.0);
    CHECK(passes["balls"] == 4.0);
    std::ostringstream line;
    app::print_bench_row(line, row, limits);
    CHECK(line.str().find("passes: visibility 6.000 shadows 1.000 surroundings 2.000 balls 4.000 overlay 0.500 ms") !=
          std::string::npos);
    const app::ReportOrigin origin{{{"device", "d"}, {"driver", "e"}}, "ballpit bench", "today"};
    const std::string csv = app::bench_csv(std::vector{row}, limits, origin);
    CHECK(csv.find(",picture_visibility_ms,picture_shadows_ms,picture_surroundings_ms,picture_balls_ms,picture_overlay_"
                   "ms\n") != std::string::npos);
    CHECK(csv.find(",6,1,2,4,0.5\n") != std::string::npos);
}

TEST_CASE("times that the device's clock has lost are told of", "[bench]") {
    app::BenchRow row;
    const measure::DeviceLimits limits;
    std::ostringstream none;
    app::print_bench_row(none, row, limits);
    CHECK(none.str().find("left out") == std::string::npos);
    row.lost_times = 3;
    std::ostringstream line;
    app::print_bench_row(line, row, limits);
    CHECK(line.str().find("3 times are left out") != std::string::npos);
    CHECK(app::bench_row_json(row, limits)["lost_times"] == 3);
}

TEST_CASE("a row takes fewer steps where they would take too long", "[bench]") {
    Simulation simulation = settled_pile(2000);
    const Checkpoint start = simulation.checkpoint();
    app::BenchPlan plan;
    plan.steps = 100000;
    plan.limit_s = 0.2;
    const app::BenchRow row = app::measure_row(simulation, start, simulation.settings(), plan, generous());
    CHECK(row.steps >= 2);
    CHECK(row.steps < 1000);
    CHECK(row.substep_ms.size() == row.steps);
}
