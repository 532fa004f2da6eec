// The probe of single collisions on the GPU: the same answers, and a spoiled shader is noticed.
#include "measure/collision_probe.h"

#include <cmath>

#include "core/scene_schedule.h"
#include "core/simulation.h"
#include "cpu/cpu_backend.h"
#include "support/gl_fixture.h"
#include "support/gpu_backend.h"
#include "support/probe_contract.h"
#include "support/shader_copy.h"

using namespace ballpit;
using test::GlFixture;

TEST_CASE_METHOD(GlFixture, "the GPU's probe finds what the integrators do", "[gpu-probe]") {
    const auto backend = test::gpu_backend();
    test::probe_finds_historical_gain(*backend);
    CHECK(test::damped_mean_is_right(*backend));
}

TEST_CASE_METHOD(GlFixture, "GPU and mirror probe alike", "[gpu-probe]") {
    measure::ProbeQuestion question = test::damped_question(0.1, true, 12.0);
    question.settings.laws.contact = true;
    const auto gpu = test::gpu_backend();
    cpu::CpuBackend<float> mirror;
    const measure::ProbeResult there = measure::run_probe(*gpu, question);
    const measure::ProbeResult here = measure::run_probe(mirror, question);
    REQUIRE(there.groups.size() == 4);
    REQUIRE(here.groups.size() == 4);
    for (std::size_t i = 0; i < 4; ++i) {
        CAPTURE(i);
        // Roundings differ (docs/accuracy.md); one may decide whether a first sample touches.
        const double margin = test::rounds_like_the_cpu(*gpu) ? 0.0 : 1e-4;
        CHECK(std::abs(there.groups[i].restitution.mean - here.groups[i].restitution.mean) <= margin);
        CHECK(std::abs(there.groups[i].overlap.mean - here.groups[i].overlap.mean) <= margin);
        CHECK(there.groups[i].duration.mean == Approx(here.groups[i].duration.mean).epsilon(margin * 100.0 + 1e-12));
    }
}

TEST_CASE_METHOD(GlFixture, "a dashpot half as strong is found by the probe", "[gpu-probe]") {
    const test::ShaderCopy copy;
    copy.replace("shared/contact.glsl", "2.0 * damping_ratio", "1.0 * damping_ratio");
    gpu::GpuBackend spoiled(copy.path());
    CHECK_FALSE(test::damped_mean_is_right(spoiled));
}

TEST_CASE_METHOD(GlFixture, "a probe of the running settings compiles nothing", "[gpu-probe]") {
    const auto programs = std::make_shared<gpu::Programs>(test::shader_folder());
    const Scene scene = test::shipped_scene("rain");
    programs->set_shipped(shipped_programs(std::span(&scene, 1)));
    const World world = make_world(scene, 200, 1);
    Settings settings = scene.settings;
    settings.balls = 200;
    Simulation simulation(scene, settings, 1, std::make_unique<gpu::GpuBackend>(programs));
    REQUIRE(programs->on_demand().empty());
    gpu::GpuBackend probe(programs);
    const auto of_scene = measure::probe_scene(world.balls, settings, simulation.box(), simulation.variety());
    const measure::ProbeResult result = measure::run_probe(probe, {settings, of_scene});
    CHECK(result.groups.size() == 4);
    CHECK(result.unending() == 0);
    CHECK(programs->on_demand().empty());
    settings.laws.drag = false;
    measure::run_probe(probe, {settings, of_scene});
    CHECK(programs->on_demand().size() == 1);  // it would have been noticed
}
