// What a scene asks for follows from its laws alone: the smallest sets of passes, buffers and barriers.
#include "core/ledger.h"

#include <algorithm>

#include "core/scene_schedule.h"
#include "core/simulation.h"
#include "cpu/cpu_backend.h"
#include "support/catch.h"
#include "support/law_scenes.h"
#include "support/scenes.h"
#include "support/unread_contract.h"

using namespace ballpit;

namespace {

bool binds(const Schedule& schedule, Slot slot) {
    const std::vector<Slot> slots = bound_slots(schedule);
    return std::ranges::find(slots, slot) != slots.end();
}

bool has(const Schedule& schedule, Feature feature) { return schedule.features.has(feature); }

Schedule schedule_of(Scene scene, bool diagnostics = false) {
    scene.settings.laws.diagnostics = diagnostics;
    return first_schedule(scene);
}

}  // namespace

TEST_CASE("free fall is one dispatch and 32 bytes a ball, and nothing else", "[ledger]") {
    for (const std::uint32_t balls : {1u, 100u, 5000u, 1u << 20}) {
        const Schedule schedule = schedule_of(test::free_fall_scene(balls));
        CAPTURE(balls);
        REQUIRE(schedule.dispatches.size() == 1);
        CHECK(schedule.dispatches[0].program.shader == Shader::collide);
        CHECK(bytes_per_ball(schedule) == 32.0);
        CHECK(count_barriers(schedule).within == 0);
        CHECK(count_barriers(schedule).before == 1);  // it reads what the substep before has written
        CHECK(dispatches_of(schedule, Stage::bitonic_sort) == 0);
        CHECK(schedule.cell_count == 0);
        CHECK(bound_slots(schedule) == std::vector{Slot::positions, Slot::velocities});
        CHECK(schedule.features.bits == static_cast<std::uint32_t>(Feature::gravity));
    }
}

TEST_CASE("rain with drag and walls, but no contacts, has no grid and no sort", "[ledger]") {
    const Schedule schedule = schedule_of(test::scene_with("gravity,drag,restitution,walls", 500));
    CHECK(schedule.dispatches.size() == 1);
    CHECK(bytes_per_ball(schedule) == 32.0);
    CHECK(bound_slots(schedule) == std::vector{Slot::positions, Slot::velocities});
}

TEST_CASE("an elastic gas has no dashpot, no gravity and no drag", "[ledger]") {
    const Schedule schedule = schedule_of(test::elastic_gas_scene(500));
    for (const Feature absent : {Feature::dashpot, Feature::limit_force, Feature::gravity, Feature::drag,
                                 Feature::ball_restitution, Feature::moving_walls, Feature::unequal_radii}) {
        CHECK_FALSE(has(schedule, absent));
    }
    CHECK_FALSE(binds(schedule, Slot::damping_ratios));
    CHECK(binds(schedule, Slot::cell_ranges));
}

TEST_CASE("a dispatch waits where it uses what an earlier one has written, and nowhere else", "[ledger]") {
    // assign_cells waits for the state, the sort for the keys, build_grid for keys and cleared cells, collide for the
    // ranges and the copies. clear_cells need not, because an earlier barrier already covers the collide that read the
    // cells; nor gather, because build_grid has waited for the keys.
    const Schedule fused = schedule_of(test::mono_pile_scene(500));
    REQUIRE(fused.dispatches.size() == 6);
    CHECK(count_barriers(fused).before == 1);
    CHECK(count_barriers(fused).within == 3);
    Scene scene = test::mono_pile_scene(500);
    scene.settings.sort = SortMethod::bitonic;
    const Schedule passes = schedule_of(scene);
    CHECK(count_barriers(passes).within == 2 + dispatches_of(passes, Stage::bitonic_sort));
    scene.settings.neighbours = NeighbourSearch::brute_force;
    CHECK(count_barriers(schedule_of(scene)).before == 1);
    CHECK(count_barriers(schedule_of(scene)).within == 0);
    CHECK(count_barriers(Schedule{}).before == 0);
}

TEST_CASE("a few balls without a grid have no keys and no cells", "[ledger]") {
    Scene scene = test::scene_with("contact", 5);
    scene.settings.neighbours = NeighbourSearch::brute_force;
    const Schedule schedule = schedule_of(scene);
    CHECK(schedule.dispatches.size() == 1);
    CHECK(bytes_per_ball(schedule) == 64.0);
    CHECK_FALSE(binds(schedule, Slot::keys));
}

TEST_CASE("only balls that differ have radii, masses and restitutions of their own", "[ledger]") {
    const Schedule mono = schedule_of(test::mono_pile_scene(300));
    CHECK_FALSE(has(mono, Feature::unequal_radii));
    CHECK_FALSE(has(mono, Feature::unequal_masses));
    CHECK_FALSE(binds(mono, Slot::damping_ratios));
    const Schedule mixed = schedule_of(test::mixed_pile_scene(300));
    CHECK(has(mixed, Feature::unequal_radii));
    CHECK(has(mixed, Feature::unequal_masses));
    Scene own = test::mono_pile_scene(300);
    own.balls.push_back({dvec3(0.0), dvec3(0.0), 0.08, 1.0, 0.2});
    ++own.settings.balls;
    Scene common = own;
    common.balls[0].restitution.reset();
    CHECK(binds(schedule_of(own), Slot::damping_ratios));
    CHECK_FALSE(binds(schedule_of(common), Slot::damping_ratios));
    CHECK(bytes_per_ball(schedule_of(own)) == Approx(bytes_per_ball(schedule_of(common)) + 4.0));
    own.settings.laws = parse_laws("gravity");  // nothing touches: nothing is stored
    CHECK(bytes_per_ball(schedule_of(own)) == 32.0);
}

TEST_CASE("the status word is bound where stages count what goes wrong, and only there", "[ledger]") {
    for (const Scene& scene : {test::free_fall_scene(100), test::mono_pile_scene(100)}) {
        CHECK(binds(schedule_of(scene, true), Slot::status));
        CHECK_FALSE(binds(schedule_of(scene, false), Slot::status));
    }
}

TEST_CASE("the cost of free fall is linear in its balls and depends on nothing else", "[ledger]") {
    const auto groups_of = [](const Scene& scene) {
        const Schedule schedule = first_schedule(scene);
        REQUIRE(schedule.dispatches.size() == 1);
        const Groups groups = schedule.dispatches[0].groups;
        return groups.x * groups.y;
    };
    for (std::uint32_t balls = GROUP_SIZE; balls <= (1u << 20); balls *= 4) {
        CAPTURE(balls);
        CHECK(groups_of(test::free_fall_scene(balls)) == balls / GROUP_SIZE);
        for (const double size : {0.5, 1.0, 1000.0}) {
            Scene scene = test::free_fall_scene(balls);
            scene.half_extent = dvec3(size);
            scene.settings.cell_factor = 4.0 * size;
            scene.fill->radius = {1e-3 * size, 1e-3 * size};
            CHECK(groups_of(scene) == balls / GROUP_SIZE);
            CHECK(bytes_of(first_schedule(scene)) == bytes_of(first_schedule(test::free_fall_scene(balls))));
        }
    }
}

TEST_CASE("the ledger speaks of the schedule that runs", "[ledger]") {
    for (const std::string_view name : test::shipped_scene_names) {
        const Scene scene = test::shipped_scene(name);
        const Simulation simulation(scene, scene.settings, test::seed_of(scene),
                                    std::make_unique<cpu::CpuBackend<float>>());
        const Schedule told = first_schedule(scene);
        const Schedule& runs = simulation.schedule();
        CAPTURE(name);
        CHECK(told.features == runs.features);
        CHECK(told.cell_count == runs.cell_count);
        CHECK(told.key_count == runs.key_count);
        CHECK(told.in_place == runs.in_place);
        REQUIRE(told.dispatches.size() == runs.dispatches.size());
        const std::vector<Program> built = shipped_programs({&scene, 1});
        for (std::size_t i = 0; i < told.dispatches.size(); ++i) {
            CHECK(told.dispatches[i].program == runs.dispatches[i].program);
            CHECK(told.dispatches[i].groups == runs.dispatches[i].groups);
            CHECK(std::ranges::find(built, runs.dispatches[i].program) != built.end());
        }
    }
}

TEST_CASE("the mirror keeps the bytes that the ledger tells", "[ledger]") {
    for (const char* laws : {"gravity", "gravity,walls,ball_restitution", "contact,walls", "gravity,ball_restitution",
                             "gravity,compensated", "contact,walls,compensated"}) {
        const Scene scene = test::scene_with(laws, 200);
        Simulation simulation(scene, scene.settings, 1, std::make_unique<cpu::CpuBackend<float>>());
        const auto bytes = bytes_of(simulation.schedule());
        for (std::size_t i = 0; i < slot_count; ++i) {
            CAPTURE(laws, slot_names[i]);
            CHECK(simulation.backend().read(static_cast<Slot>(i)).size() == bytes[i]);
        }
    }
}

TEST_CASE("a row says what it does without", "[ledger]") {
    const auto says = [](const Schedule& schedule, std::string_view what) {
        const auto all = absences(schedule);
        return std::ranges::find(all, what) != all.end();
    };
    const Schedule fall = schedule_of(test::free_fall_scene(10));
    for (const char* what : {"grid", "sort", "second state", "neighbours", "walls", "radius", "mass", "drag"}) {
        CHECK(says(fall, what));
    }
    CHECK_FALSE(says(fall, "gravity"));
    CHECK(says(schedule_of(test::elastic_gas_scene(10)), "neighbours' velocities"));
    const Schedule pile = schedule_of(test::mixed_pile_scene(10), true);
    for (const char* what : {"grid", "neighbours' velocities", "walls", "dashpot", "radius read", "diagnostics"}) {
        CHECK_FALSE(says(pile, what));
    }
}

TEST_CASE("the mirror reads of other balls only what counts", "[ledger]") {
    cpu::CpuBackend<float> mirror;
    test::reads_only_what_counts(mirror);
}

TEST_CASE("the least bytes of a dispatch are those of the slots that it reads and writes as a whole", "[ledger]") {
    Scene scene = test::mono_pile_scene(1024);
    const Schedule schedule = schedule_of(scene);
    const std::size_t state = 1024 * sizeof(vec4);
    const std::size_t keys = 1024 * sizeof(Key);
    CHECK(least_bytes(schedule, Stage::assign_cells) == state + keys);
    CHECK(least_bytes(schedule, Stage::bitonic_sort) == 2 * keys);  // one tile: read once, written once
    // Which tiles of the table are cleared, and which of its cells are written, is the state's affair.
    CHECK(least_bytes(schedule, Stage::build_grid) ==
          2 * tile_count(schedule.cell_count) * sizeof(std::uint32_t) + keys);
    CHECK(least_bytes(schedule, Stage::collide) == 8 * state + 2 * keys);  // copied, then read from the copies
    scene.settings.sort = SortMethod::bitonic;
    // A pass reads every key; which of them change places is the state's affair, too.
    CHECK(least_bytes(schedule_of(scene), Stage::bitonic_sort) == 55 * keys);
    CHECK(least_bytes(schedule_of(test::free_fall_scene(1000)), Stage::bitonic_sort) == 0);
    CHECK(least_bytes(schedule_of(test::free_fall_scene(1000)), Stage::collide) == 4 * 1000 * sizeof(vec4));
}
