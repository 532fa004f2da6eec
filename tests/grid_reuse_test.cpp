// One grid for several substeps, on the mirror: which substeps build one, and what that costs in contacts.
#include "core/grid_reuse.h"

#include "core/schedule.h"
#include "core/simulation.h"
#include "cpu/cpu_backend.h"
#include "support/catch.h"
#include "support/grid_reuse_contract.h"
#include "support/scenes.h"
#include "support/stepping.h"

using namespace ballpit;

namespace {

std::unique_ptr<Backend> mirror() { return std::make_unique<cpu::CpuBackend<float>>(); }

Features contact(bool diagnostics) {
    Features features;
    features.add(Feature::contact);
    features.add(Feature::diagnostics, diagnostics);
    return features;
}

Schedule schedule_of(std::uint32_t reuse, Features features) {
    return make_schedule(100, make_grid(dvec3(1.0), 0.1, 1.0, 100), features, SortMethod::bitonic_fused, reuse);
}

std::vector<std::string> names_of(const Schedule& schedule) {
    std::vector<std::string> names;
    for (const Dispatch& dispatch : schedule.dispatches) {
        names.push_back(dispatch.name);
    }
    return names;
}

Simulation simulation_with(std::uint32_t reuse, std::uint32_t substeps) {
    Simulation simulation = test::stepping_simulation(mirror(), SortMethod::bitonic_fused);
    Settings settings = simulation.settings();
    settings.grid_reuse = reuse;
    settings.substeps = substeps;
    simulation.change(settings);
    return simulation;
}

std::string builds(Simulation& simulation, int substeps) {
    std::string text;
    for (int i = 0; i < substeps; ++i) {
        text += simulation.builds_grid() ? 'B' : '.';
        simulation.substep();
    }
    return text;
}

}  // namespace

TEST_CASE("a grid that is used again is built with its counters, and then left out", "[grid_reuse]") {
    const Schedule once = schedule_of(1, contact(true));
    const Schedule again = schedule_of(4, contact(true));
    CHECK_FALSE(once.keeps_places);
    CHECK(again.keeps_places);
    auto expected = names_of(once);
    expected.insert(expected.end() - 1, {"count_missed", "keep_places"});
    CHECK(names_of(again) == expected);
    CHECK(names_of(with_grid_reused(again)) == std::vector<std::string>{"collide"});
    CHECK(with_grid_reused(again).key_count == again.key_count);
}

TEST_CASE("without diagnostics nothing is counted and nothing kept", "[grid_reuse]") {
    const Schedule schedule = schedule_of(4, contact(false));
    CHECK_FALSE(schedule.keeps_places);
    CHECK(names_of(schedule) == names_of(schedule_of(1, contact(false))));
}

TEST_CASE("without a grid there is nothing to use again", "[grid_reuse]") {
    Features brute_force = contact(true);
    brute_force.add(Feature::brute_force);
    for (const Features features : {brute_force, Features{}}) {
        const Schedule schedule = schedule_of(4, features);
        CHECK_FALSE(schedule.keeps_places);
        CHECK(names_of(with_grid_reused(schedule)) == names_of(schedule));
    }
    Simulation simulation = simulation_with(4, 8);
    Settings settings = simulation.settings();
    settings.neighbours = NeighbourSearch::brute_force;
    simulation.change(settings);
    CHECK(builds(simulation, 4) == "BBBB");
}

TEST_CASE("every step builds its grid, and every so many substeps after that", "[grid_reuse]") {
    Simulation simulation = simulation_with(3, 8);
    CHECK(builds(simulation, 16) == "B..B..B.B..B..B.");
    Simulation longer = simulation_with(64, 4);
    CHECK(builds(longer, 8) == "B...B...");
    Simulation always = simulation_with(1, 4);
    CHECK(builds(always, 5) == "BBBBB");
}

TEST_CASE("after a change, another backend or a checkpoint a grid is built", "[grid_reuse]") {
    Simulation simulation = simulation_with(8, 8);
    CHECK(builds(simulation, 3) == "B..");
    Settings settings = simulation.settings();
    settings.gravity.x = 1.0;
    simulation.apply(settings);
    CHECK(builds(simulation, 2) == "B.");
    simulation.apply(settings);  // nothing is changed: a replay must not know more than that
    CHECK(builds(simulation, 1) == "B");
    simulation.substep();
    simulation.use(mirror());
    CHECK(builds(simulation, 8) == "BB......");
    const Checkpoint checkpoint = simulation.checkpoint();
    CHECK_FALSE(simulation.builds_grid());
    simulation.restore(checkpoint);
    CHECK(simulation.builds_grid());
}

TEST_CASE("the skin and the advice are lengths of this scene", "[grid_reuse]") {
    const Grid grid = make_grid(dvec3(1.0), 0.1, 1.5, 100);
    CHECK(skin(grid, 0.1) == Approx(0.1).epsilon(1e-3));
    Status status{};
    CHECK(drift(status) == 0.0);
    CHECK(cell_factor_for(0.0, 0.1) == 1.0);
    const double advised = cell_factor_for(0.04, 0.1);
    CHECK(advised == 1.25);
    CHECK(skin(make_grid(dvec3(1.0), 0.1, advised, 100), 0.1) > 0.04);
}

TEST_CASE("mirror: wide cells miss nothing", "[grid_reuse]") { test::wide_cells_miss_nothing(mirror); }

TEST_CASE("mirror: missed contacts are counted", "[grid_reuse]") { test::missed_contacts_are_counted(mirror); }

TEST_CASE("mirror: with a grid used again, back and forth give the bytes of the way there", "[grid_reuse]") {
    test::steps_back_and_forth(mirror);
}

TEST_CASE("mirror: looking in between leaves a used grid alone", "[grid_reuse]") {
    test::looking_changes_nothing(mirror);
}
