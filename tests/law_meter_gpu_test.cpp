// Costs of laws on the GPU, and programs that are built ahead or on demand.
#include "core/scene_schedule.h"
#include "support/gl_fixture.h"
#include "support/gpu_backend.h"
#include "support/law_meter_contract.h"

using namespace ballpit;
using test::GlFixture;

TEST_CASE_METHOD(GlFixture, "the GPU's laws are measured, and the simulation does not notice", "[gpu-programs]") {
    test::measures_every_law([] { return test::gpu_backend(); });
}

TEST_CASE_METHOD(GlFixture, "where the state is kept makes no other set of laws", "[gpu-programs]") {
    const auto programs = std::make_shared<gpu::Programs>(test::shader_folder());
    const Scene scene = test::shipped_scene("pile");
    programs->set_shipped(shipped_programs(std::span(&scene, 1)));
    Settings settings = scene.settings;
    settings.balls = 100;
    settings.sort = SortMethod::counting;
    Simulation simulation(scene, settings, 1, std::make_unique<gpu::GpuBackend>(programs));
    REQUIRE(simulation.whole_schedule().keeps_order);
    settings.keep_order = settings.sorted_copies = false;
    simulation.change(settings);
    CHECK(programs->on_demand().empty());
}

TEST_CASE_METHOD(GlFixture, "what shipped scenes run is built ahead, anything else on demand and noted",
                 "[gpu-programs]") {
    const auto programs = std::make_shared<gpu::Programs>(test::shader_folder());
    const Scene scene = test::shipped_scene("two_balls");
    programs->set_shipped(shipped_programs(std::span(&scene, 1)));
    int built = 0;
    while (programs->build_one()) {
        ++built;
    }
    CHECK(built > 0);
    Simulation simulation(scene, scene.settings, 1, std::make_unique<gpu::GpuBackend>(programs));
    simulation.step();
    CHECK(programs->on_demand().empty());
    Settings settings = scene.settings;
    settings.laws.drag = !settings.laws.drag;
    simulation.change(settings);
    REQUIRE(programs->on_demand().size() == 1);
    CHECK(programs->on_demand()[0].program.shader == Shader::collide);
    CHECK(programs->on_demand()[0].ms > 0.0);
    Simulation twin(scene, settings, 1, std::make_unique<gpu::GpuBackend>(programs));
    CHECK(programs->on_demand().size() == 1);  // backends share what is compiled
}
