#include "support/counting_contract.h"

#include "core/hash.h"
#include "core/simulation.h"
#include "support/catch.h"
#include "support/scenes.h"
#include "support/substep_setup.h"

namespace ballpit::test {

namespace {

struct Way {
    SortMethod sort;
    bool sorted_copies;
    bool keep_order;
};
constexpr std::array ways = {Way{SortMethod::bitonic, false, false}, Way{SortMethod::bitonic_fused, true, true},
                             Way{SortMethod::counting, false, true}, Way{SortMethod::counting, true, false},
                             Way{SortMethod::counting, true, true}};

Settings computed(Settings settings, const Way& way) {
    settings.sort = way.sort;
    settings.sorted_copies = way.sorted_copies;
    settings.keep_order = way.keep_order;
    return settings;
}

void run(Simulation& simulation, int steps) {
    for (int step = 0; step < steps; ++step) {
        simulation.step();
    }
}

}  // namespace

void same_run_however_computed(const MakeBackend& make, std::uint32_t balls, int steps) {
    for (const std::string_view name : shipped_scene_names) {
        const Scene scene = shipped_scene(name);
        Settings settings = scene.settings;
        settings.balls = scene.fill ? std::max<std::uint32_t>(balls, static_cast<std::uint32_t>(scene.balls.size()))
                                    : settings.balls;
        settings.substeps = std::min(settings.substeps, 8u);
        std::optional<std::uint64_t> expected;
        for (const Way& way : ways) {
            CAPTURE(name, sort_names[static_cast<std::size_t>(way.sort)], way.sorted_copies, way.keep_order);
            Simulation simulation(scene, computed(settings, way), 1, make());
            run(simulation, steps);
            const std::uint64_t hash = hash_state(simulation.raw_state());
            CHECK(hash == expected.value_or(hash));
            expected = hash;
        }
    }
}

void changes_of_computing_change_nothing(const MakeBackend& make) {
    const Scene scene = shipped_scene("pile");
    Settings settings = scene.settings;
    settings.balls = 300;
    settings.substeps = 3;
    Simulation steady(scene, settings, 1, make());
    Simulation changing(scene, settings, 1, make());
    for (int round = 0; round < 8; ++round) {
        changing.change(computed(changing.settings(), ways[static_cast<std::size_t>(round) % ways.size()]));
        changing.substep();
        steady.substep();
    }
    CHECK(hash_state(changing.raw_state()) == hash_state(steady.raw_state()));
    CHECK(status_of(changing.backend()).bits == status_of(steady.backend()).bits);
}

void automatic_sort_is_one_of_them(const MakeBackend& make) {
    Scene scene = shipped_scene("rain");
    Settings settings = scene.settings;
    settings.balls = 500;
    settings.walls_low = dvec3(0.0);
    Simulation fixed(scene, settings, 1, make());
    settings.sort = SortMethod::automatic;
    Simulation open(scene, settings, 1, make());
    CHECK(open.settings().sort == SortMethod::automatic);
    CHECK(status_of(open.backend()).out_of_bounds == status_of(fixed.backend()).out_of_bounds);
    const auto stages = [&](Stage stage) {
        return std::ranges::count(open.schedule().dispatches, stage, &Dispatch::stage);
    };
    CHECK((stages(Stage::counting_sort) > 0) != (stages(Stage::bitonic_sort) > 0));
    run(fixed, 5);
    run(open, 5);
    CHECK(hash_state(open.raw_state()) == hash_state(fixed.raw_state()));
    Settings fewer = open.settings();
    fewer.balls = 3;
    open.change(fewer);
    run(open, 2);
    CHECK(open.raw_state().count() == 3);
}

}  // namespace ballpit::test
