#include "support/grid_reuse_contract.h"

#include <cmath>

#include "core/grid_reuse.h"
#include "core/simulation.h"
#include "measure/check.h"
#include "support/catch.h"
#include "support/scenes.h"
#include "support/stepping.h"

namespace ballpit::test {

namespace {

// A gas that touches often; a substep is short of a contact, a step long enough for balls to leave their cells.
Simulation gas(std::unique_ptr<Backend> backend, std::uint32_t reuse, double cell_factor, double speed = 1.0) {
    Scene scene;
    scene.name = "gas";
    scene.half_extent = dvec3(1.0);
    scene.settings.laws = parse_laws("contact,restitution,walls,diagnostics");
    scene.fill = Fill{300, {0.05, 0.08}, 1000.0, speed, {dvec3(-0.9), dvec3(0.9)}, 11};
    scene.settings.balls = 300;
    scene.settings.stiffness = 2e5;
    scene.settings.substeps = 32;
    scene.settings.grid_reuse = reuse;
    scene.settings.cell_factor = cell_factor;
    return {scene, scene.settings, 11, std::move(backend)};
}

Status status_of(Simulation& simulation) { return read_slot<Status>(simulation.backend(), Slot::status).front(); }

dvec3 cell_of(const Grid& grid, const vec4& position) {
    const dvec3 cell = glm::floor((dvec3(position) - grid.origin) / grid.cell_width);
    return glm::clamp(cell, dvec3(0.0), dvec3(grid.cells) - 1.0);
}

struct Counted {
    std::uint32_t missed = 0;
    double drift = 0.0;
};

// By asking every pair.
Counted count_pairs(const std::vector<vec4>& now, const std::vector<vec4>& built, const Grid& grid) {
    Counted counted;
    for (std::size_t i = 0; i < now.size(); ++i) {
        counted.drift = std::max(counted.drift, glm::distance(dvec3(now[i]), dvec3(built[i])));
        for (std::size_t j = 0; j < now.size(); ++j) {
            const double reach = static_cast<double>(now[i].w) + static_cast<double>(now[j].w);
            const dvec3 apart = glm::abs(cell_of(grid, now[i]) - cell_of(grid, built[j]));
            const bool touches = i != j && glm::distance(dvec3(now[i]), dvec3(now[j])) < reach;
            counted.missed += touches && glm::any(glm::greaterThan(apart, dvec3(1.0))) ? 1 : 0;
        }
    }
    return counted;
}

}  // namespace

void wide_cells_miss_nothing(const MakeBackend& make) {
    Simulation each = gas(make(), 1, 1.0);
    Simulation reused = gas(make(), 8, 1.5);
    each.step();
    reused.step();
    const Status status = status_of(reused);
    CHECK(status.missed == 0);
    CHECK(drift(status) > 0.0);
    CHECK(drift(status) < skin(reused.schedule().grid, reused.largest_ball_radius()));
    const BallState a = each.raw_state();
    const BallState b = reused.raw_state();
    double farthest = 0.0;
    double way = 0.0;
    const BallState start = gas(make(), 1, 1.0).raw_state();
    for (std::size_t i = 0; i < a.count(); ++i) {
        farthest = std::max(farthest, glm::distance(dvec3(a.positions[i]), dvec3(b.positions[i])));
        way = std::max(way, glm::distance(dvec3(a.positions[i]), dvec3(start.positions[i])));
    }
    CHECK(way > 0.01);
    CHECK(farthest < 1e-5);  // m: sums in another order, through a few contacts
}

void missed_contacts_are_counted(const MakeBackend& make) {
    constexpr std::uint32_t reuse = 16;
    Simulation simulation = gas(make(), reuse, 1.0, 20.0);
    const Grid grid = simulation.schedule().grid;
    std::uint32_t missed = 0;
    double farthest = 0.0;
    auto built = read_slot<vec4>(simulation.backend(), Slot::positions);
    for (int period = 0; period < 12; ++period) {
        REQUIRE(simulation.builds_grid());
        const auto now = read_slot<vec4>(simulation.backend(), Slot::positions);
        const Counted counted = count_pairs(now, built, grid);
        built = now;
        missed += counted.missed;
        farthest = std::max(farthest, counted.drift);
        simulation.substep();
        const Status status = status_of(simulation);
        INFO("period " << period);
        CHECK(status.missed == missed);
        CHECK(drift(status) == Approx(farthest).epsilon(1e-5));
        CHECK(((status.bits & STATUS_MISSED) != 0) == (missed > 0));
        CHECK(read_slot<vec4>(simulation.backend(), Slot::built_positions) == built);
        for (std::uint32_t i = 1; i < reuse; ++i) {
            CHECK_FALSE(simulation.builds_grid());
            simulation.substep();
        }
    }
    CHECK(missed > 10);
    // What is advised is enough.
    Simulation advised = gas(make(), reuse, cell_factor_for(farthest, simulation.largest_ball_radius()), 20.0);
    for (int step = 0; step < 6; ++step) {
        advised.step();
    }
    CHECK(status_of(advised).missed == 0);
}

void steps_back_and_forth(const MakeBackend& make) {
    Simulation simulation = stepping_simulation(make(), SortMethod::bitonic_fused);
    Settings settings = simulation.settings();
    settings.grid_reuse = 3;
    settings.substeps = 5;
    simulation.change(settings);
    check_every_position(simulation);
}

void looking_changes_nothing(const MakeBackend& make) {
    Simulation looked_at = gas(make(), 4, 1.0, 20.0);
    Simulation left_alone = gas(make(), 4, 1.0, 20.0);
    looked_at.set_metering(true);
    for (int i = 0; i < 40; ++i) {
        looked_at.synchronised_state();
        looked_at.meter();
        looked_at.substep();
        left_alone.substep();
        looked_at.take_records();
    }
    CHECK(hash_state(looked_at.raw_state()) == hash_state(left_alone.raw_state()));
    const Status looked = status_of(looked_at);
    const Status left = status_of(left_alone);
    CHECK(looked.bits == left.bits);
    CHECK(looked.missed == left.missed);
    CHECK(looked.out_of_bounds == left.out_of_bounds);
    CHECK(drift(looked) == drift(left));
    CHECK(left.missed > 0);
}

}  // namespace ballpit::test
