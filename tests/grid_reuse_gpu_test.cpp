// One grid for several substeps, on the GPU.
#include "cpu/cpu_backend.h"
#include "gpu/gpu_backend.h"
#include "measure/check.h"
#include "support/catch.h"
#include "support/gl_fixture.h"
#include "support/grid_reuse_contract.h"
#include "support/scenes.h"

using namespace ballpit;
using namespace ballpit::test;

namespace {

std::unique_ptr<Backend> on_gpu() { return std::make_unique<gpu::GpuBackend>(BALLPIT_SOURCE_DIR "/glsl"); }

}  // namespace

TEST_CASE_METHOD(GlFixture, "GPU: wide cells miss nothing", "[grid_reuse]") { wide_cells_miss_nothing(on_gpu); }

TEST_CASE_METHOD(GlFixture, "GPU: missed contacts are counted", "[grid_reuse]") { missed_contacts_are_counted(on_gpu); }

TEST_CASE_METHOD(GlFixture, "GPU: with a grid used again, back and forth give the bytes of the way there",
                 "[grid_reuse]") {
    steps_back_and_forth(on_gpu);
}

TEST_CASE_METHOD(GlFixture, "GPU: looking in between leaves a used grid alone", "[grid_reuse]") {
    looking_changes_nothing(on_gpu);
}

TEST_CASE_METHOD(GlFixture, "GPU and mirror agree on every stage of a grid that is used again", "[grid_reuse]") {
    for (const char* name : {"rain", "mixed_sizes"}) {
        const Scene scene = shipped_scene(name);
        Settings settings = scene.settings;
        settings.balls = 500;
        settings.grid_reuse = 4;
        Simulation simulation(scene, settings, 3, on_gpu());
        for (int i = 0; i < 20; ++i) {
            simulation.step();
        }
        simulation.substep();  // in the middle of a period: the mirror has to be told the grid that is used
        cpu::CpuBackend<float> mirror;
        const measure::CheckReport report = measure::check(simulation, mirror, 3);
        INFO(name);
        CHECK(report.passed());
        for (const measure::CheckRow& row : report.rows) {
            if (row.stage != Stage::collide) {
                CHECK(row.differing == 0);
            }
        }
    }
}
