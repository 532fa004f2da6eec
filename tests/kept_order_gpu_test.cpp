// Balls that stay in the order of their cells on the GPU: nobody sees it, but for the time that it takes.
#include <limits>

#include "core/hash.h"
#include "core/stepper.h"
#include "cpu/cpu_backend.h"
#include "gpu/gpu_backend.h"
#include "measure/check.h"
#include "support/catch.h"
#include "support/gl_fixture.h"
#include "support/gpu_backend.h"
#include "support/scenes.h"
#include "support/shader_copy.h"
#include "support/substep_setup.h"

using namespace ballpit;
using test::GlFixture;

namespace {

Settings settings_for(const Scene& scene, bool keep_order) {
    Settings settings = scene.settings;
    settings.balls = 700;
    settings.substeps = 6;
    settings.sort = SortMethod::counting;
    settings.keep_order = keep_order;
    return settings;
}

// The same run twice, the one in the order of the cells, and after each step the same look at both.
template <class Look>
void same_after_each(const Scene& scene, Settings settings, int steps, const Look& look) {
    settings.keep_order = true;
    Simulation kept(scene, settings, 1, test::gpu_backend());
    settings.keep_order = false;
    Simulation plain(scene, settings, 1, test::gpu_backend());
    REQUIRE(kept.whole_schedule().keeps_order);
    REQUIRE_FALSE(plain.whole_schedule().keeps_order);
    for (int step = 0; step < steps; ++step) {
        CAPTURE(step);
        look(step, kept);
        look(step, plain);
        kept.step();
        plain.step();
        CHECK(hash_state(kept.raw_state()) == hash_state(plain.raw_state()));
    }
    CHECK(test::status_of(kept.backend()).bits == test::status_of(plain.backend()).bits);
    CHECK(test::status_of(kept.backend()).missed == test::status_of(plain.backend()).missed);
}

void nothing(int, Simulation&) {}

}  // namespace

TEST_CASE_METHOD(GlFixture, "the state stays in order until it is put elsewhere, and looking at it leaves it there",
                 "[gpu][kept_order]") {
    const Scene scene = test::shipped_scene("pile");
    Simulation simulation(scene, settings_for(scene, true), 1, test::gpu_backend());
    auto& backend = simulation.backend();
    CHECK_FALSE(backend.is_in_order());
    simulation.substep();
    CHECK(backend.is_in_order());
    const auto looked = simulation.raw_state();
    CHECK(backend.is_in_order());
    CHECK(hash_state(simulation.raw_state()) == hash_state(looked));
    backend.write(Slot::positions, std::as_bytes(std::span(looked.positions)));
    CHECK_FALSE(backend.is_in_order());
    CHECK(hash_state(simulation.raw_state()) == hash_state(looked));
    simulation.substep();
    CHECK(backend.is_in_order());
    backend.run(simulation.schedule(), simulation.params(), 0, 1);  // somebody steps
    CHECK_FALSE(backend.is_in_order());
}

TEST_CASE_METHOD(GlFixture, "one dispatch puts the state back, however many look", "[gpu][kept_order]") {
    const Scene scene = test::shipped_scene("pile");
    Simulation simulation(scene, settings_for(scene, true), 1, test::gpu_backend());
    auto& backend = dynamic_cast<gpu::GpuBackend&>(simulation.backend());
    simulation.step();
    const std::uint64_t before = backend.dispatches_issued();
    simulation.substep();
    CHECK(backend.dispatches_issued() == before + simulation.whole_schedule().dispatches.size());
    backend.read(Slot::positions);
    backend.read(Slot::velocities);
    backend.buffer_for_drawing(Slot::positions);
    backend.request_hash(1);
    CHECK(backend.dispatches_issued() == before + simulation.whole_schedule().dispatches.size() + 1);
}

TEST_CASE_METHOD(GlFixture, "the same bits in both orders, whatever comes between", "[gpu][kept_order]") {
    const Scene scene = test::shipped_scene("mixed_sizes");
    Settings settings = settings_for(scene, true);
    settings.laws.diagnostics = true;
    SECTION("nothing") { same_after_each(scene, settings, 12, nothing); }
    SECTION("a grid for several substeps, built anew in the middle of a step, and contacts that it misses") {
        settings.grid_reuse = 4;
        same_after_each(scene, settings, 25, [](int step, Simulation& simulation) {
            if (step % 5 == 2) {
                simulation.substep();
            }
        });
    }
    SECTION("checkpoints, meters, looks at buffers, steps by dispatch") {
        same_after_each(scene, settings, 12, [](int step, Simulation& simulation) {
            simulation.set_metering(step % 4 == 1);
            if (step == 3) {
                const Checkpoint here = simulation.checkpoint();
                simulation.step();
                simulation.restore(here);
            }
            if (step == 6) {
                simulation.backend().run(simulation.schedule(), simulation.params(), 0, 2);
                simulation.backend().run(simulation.schedule(), simulation.params(), 2,
                                         simulation.schedule().dispatches.size());
                simulation.end_substep();
            }
        });
    }
    SECTION("compensated sums and a ball that is held") {
        settings.laws.compensated = true;
        settings.pull = Pull{5, dvec3(0.1, 0.2, 0.3)};
        same_after_each(scene, settings, 12, nothing);
    }
    SECTION("a ball that goes into quarantine") {
        same_after_each(scene, settings, 8, [](int step, Simulation& simulation) {
            if (step == 2) {
                auto velocities = read_slot<vec4>(simulation.backend(), Slot::velocities);
                velocities[17].x = std::numeric_limits<float>::quiet_NaN();
                simulation.backend().write(Slot::velocities, std::as_bytes(std::span(velocities)));
            }
        });
    }
}

TEST_CASE_METHOD(GlFixture, "drawing, the hash and the history see the balls under their numbers",
                 "[gpu][kept_order]") {
    const Scene scene = test::shipped_scene("pile");
    Simulation simulation(scene, settings_for(scene, true), 1, test::gpu_backend());
    auto& backend = dynamic_cast<gpu::GpuBackend&>(simulation.backend());
    backend.start_history(1);
    simulation.step();
    simulation.substep();
    backend.record_history();
    backend.request_hash(7);
    backend.request_history();
    Simulation expected(scene, settings_for(scene, true), 1, std::make_unique<cpu::CpuBackend<float>>());
    expected.step();
    expected.substep();
    const BallState state = simulation.raw_state();
    std::vector<TaggedHash> hashes;
    std::optional<Bytes> history;
    for (int i = 0; i < 1000 && (hashes.empty() || !history); ++i) {
        backend.finish();
        std::ranges::copy(backend.take_hashes(), std::back_inserter(hashes));
        history = history ? std::move(history) : backend.poll_history();
    }
    REQUIRE(hashes.size() == 1);
    CHECK(hashes[0].hash == hash_state(state));
    REQUIRE(history);
    CHECK(typed<vec4>(*history).at(3) == state.positions[3]);
    if (test::rounds_like_the_cpu(backend)) {
        CHECK(hash_state(state) == hash_state(expected.raw_state()));
    }
}

TEST_CASE_METHOD(GlFixture, "who begins to look finds what the last substep leaves, not what a faster one left",
                 "[gpu][kept_order]") {
    const Scene scene = test::shipped_scene("pile");
    const auto all_slots = [](Backend& backend) {
        std::vector<Bytes> slots;
        for (std::size_t i = 0; i < slot_count; ++i) {
            slots.push_back(backend.read(static_cast<Slot>(i)));
        }
        return slots;
    };
    Simulation simulation(scene, settings_for(scene, true), 1, test::gpu_backend());
    const std::size_t budget =
        GENERATE(std::size_t{1} << 24, std::size_t{1} << 16);  // checkpoints a step, or steps apart
    Stepper stepper(simulation, budget);
    stepper.set_watched(false);
    for (int step = 0; step < 5; ++step) {
        stepper.forward(StepUnit::step);
    }
    CHECK(simulation.backend().is_in_order());
    stepper.set_watched(true);
    CHECK_FALSE(simulation.backend().is_in_order());
    CHECK((stepper.position() == Position{{5, 0}, 0}));
    const auto found = all_slots(simulation.backend());

    Simulation plain(scene, settings_for(scene, true), 1, test::gpu_backend());
    Stepper by_dispatch(plain, std::size_t{1} << 24);
    while (plain.step_count() < 5) {
        by_dispatch.forward(StepUnit::pass);
    }
    const auto expected = all_slots(plain.backend());
    for (std::size_t i = 0; i < slot_count; ++i) {
        CAPTURE(slot_names[i]);
        const bool same = found[i] == expected[i];
        CHECK((same || static_cast<Slot>(i) == Slot::tickets || static_cast<Slot>(i) == Slot::scattered_keys));
    }
}

TEST_CASE_METHOD(GlFixture, "mistakes of those who keep the order do not pass", "[gpu][kept_order]") {
    struct Mistake {
        const char* file;
        const char* right;
        const char* wrong;
        bool seen_by_check;  // else in a run: a check begins each time with the order of ball ids
    };
    const auto mistake = GENERATE(
        Mistake{"scatter_keys.comp", "origins[slot] = place;", "origins[slot] = slot;", true},
        Mistake{"order_keys.comp", "copy_state(origins[slot], place);", "copy_state(origins[slot], slot);", false},
        Mistake{"collide.comp", "uint next = place;", "uint next = id;", true},
        Mistake{"put_back.comp", "velocities[ball] = next_velocities[slot];",
                "velocities[slot] = next_velocities[slot];", true},
        Mistake{"start_order.comp", "Key(SENTINEL, ball)", "Key(SENTINEL, 0u)", true},
        Mistake{"assign_cells.comp", "Key(cell, keys[place].ball_id)", "Key(cell, place)", false});
    CAPTURE(mistake.file, mistake.wrong);
    const test::ShaderCopy shaders;
    shaders.replace(mistake.file, mistake.right, mistake.wrong);
    const Scene scene = test::shipped_scene("mixed_sizes");
    const auto run = [&](std::unique_ptr<Backend> backend) {
        return std::make_unique<Simulation>(scene, settings_for(scene, true), 1, std::move(backend));
    };
    const auto wrong = run(std::make_unique<gpu::GpuBackend>(shaders.path()));
    if (mistake.seen_by_check) {
        cpu::CpuBackend<float> mirror;
        CHECK_FALSE(measure::check(*wrong, mirror, 1).passed());
    } else {
        const auto right = run(test::gpu_backend());
        for (int step = 0; step < 20; ++step) {
            wrong->step();
            right->step();
        }
        CHECK(hash_state(wrong->raw_state()) != hash_state(right->raw_state()));
    }
}
