// The GPU against the mirror, dispatch by dispatch, on the scenes that ship: integers exactly, floats bit for bit
// where the device rounds as the CPU does, else within the derived bound.
#include "measure/check.h"

#include "cpu/cpu_backend.h"
#include "support/balls.h"
#include "support/catch.h"
#include "support/gl_fixture.h"
#include "support/gpu_backend.h"
#include "support/law_scenes.h"
#include "support/shader_copy.h"

using namespace ballpit;
using test::GlFixture;

namespace {

constexpr std::array sorts = {SortMethod::bitonic, SortMethod::bitonic_fused, SortMethod::counting};

void expect_agreement(const measure::CheckReport& report, bool bitwise) {
    for (const measure::CheckRow& row : report.rows) {
        CAPTURE(stage_name(row.stage), slot_name(row.slot), row.first, row.max_ulp);
        CHECK(row.beyond_bound == 0);
        CHECK((row.max_ulp == 0 || !bitwise));  // -0 counts as 0
    }
    for (const std::string& violation : report.violations) {
        FAIL_CHECK(violation);
    }
    CHECK(report.passed());
}

// `warm_up` steps first, so that contacts are met.
void check_scene(const Scene& scene, const Settings& settings, int warm_up, std::uint64_t steps) {
    Simulation simulation(scene, settings, test::seed_of(scene), test::gpu_backend());
    for (int i = 0; i < warm_up; ++i) {
        simulation.step();
    }
    cpu::CpuBackend<float> mirror;
    expect_agreement(measure::check(simulation, mirror, steps), test::rounds_like_the_cpu(simulation.backend()));
}

}  // namespace

TEST_CASE_METHOD(GlFixture, "every scene agrees with the mirror at awkward counts", "[gpu-check]") {
    for (const std::string_view name : test::shipped_scene_names) {
        const Scene scene = test::shipped_scene(name);
        for (const std::uint32_t balls : {0u, 1u, 2u, 63u, 64u, 65u}) {
            if (!scene.fill && balls > scene.balls.size()) {
                continue;
            }
            for (const SortMethod sort : sorts) {
                Settings settings = scene.settings;
                settings.balls = balls;
                settings.substeps = 4;
                settings.sort = sort;
                CAPTURE(name, balls, sort_names[static_cast<std::size_t>(sort)]);
                check_scene(scene, settings, 0, 2);
            }
        }
    }
}

TEST_CASE_METHOD(GlFixture, "every scene agrees with the mirror at its own count, in the middle of its run",
                 "[gpu-check]") {
    for (const std::string_view name : test::shipped_scene_names) {
        const Scene scene = test::shipped_scene(name);
        Settings settings = scene.settings;
        settings.substeps = 4;
        CAPTURE(name);
        check_scene(scene, settings, 60, 1);
    }
}

TEST_CASE_METHOD(GlFixture, "5000 and 65537 balls agree with the mirror in both sorts", "[gpu-check]") {
    const Scene scene = test::shipped_scene("rain");
    for (const std::uint32_t balls : {5000u, 65537u}) {
        for (const SortMethod sort : sorts) {
            Settings settings = scene.settings;
            settings.balls = balls;
            settings.substeps = 1;
            settings.sort = sort;
            CAPTURE(balls, sort_names[static_cast<std::size_t>(sort)]);
            check_scene(scene, settings, 0, 1);
        }
    }
}

TEST_CASE_METHOD(GlFixture, "every integrator and every set of laws agrees with the mirror", "[gpu-check]") {
    const Scene all = test::shipped_scene("pile");
    for (std::size_t integrator = 0; integrator < integrator_names.size(); ++integrator) {
        for (unsigned laws = 0; laws < 32; ++laws) {
            Scene scene = all;
            scene.settings.laws.gravity = (laws & 1u) != 0;
            scene.settings.laws.drag = (laws & 2u) != 0;
            scene.settings.laws.contact = (laws & 4u) != 0;
            scene.settings.laws.restitution = scene.settings.laws.contact && (laws & 8u) != 0;
            scene.settings.laws.walls = scene.settings.laws.contact && (laws & 16u) != 0;
            scene.fill->region = {dvec3(-2.5, -2.5, -3), dvec3(-1.5, -1.5, -2)};  // too small: everybody touches
            Settings settings = scene.settings;
            settings.balls = 100;
            settings.substeps = 2;
            settings.limit_force = (laws & 1u) != 0;
            settings.integrator = static_cast<Integrator>(integrator);
            CAPTURE(integrator_names[integrator], laws);
            check_scene(scene, settings, 0, 1);
        }
    }
}

TEST_CASE_METHOD(GlFixture,
                 "walls that move, a shaken box, a pulled ball, balls that differ and sums agree with the mirror",
                 "[gpu-check]") {
    for (std::size_t integrator = 0; integrator < integrator_names.size(); ++integrator) {
        for (unsigned parts = 0; parts < 32; ++parts) {
            Scene scene = test::scene_with("gravity,drag,restitution,walls", 100);
            Settings& settings = scene.settings;
            scene.half_extent = dvec3(0.5);
            scene.fill->region = {dvec3(-0.4), dvec3(0.4)};
            settings.substeps = 2;
            settings.integrator = static_cast<Integrator>(integrator);
            settings.laws.contact = (parts & 1u) != 0;
            settings.laws.shake = (parts & 2u) != 0;
            settings.walls_low = (parts & 4u) != 0 ? dvec3(0.3, 0.0, -0.2) : dvec3(0.0);
            settings.laws.compensated = (parts + integrator) % 2 == 1;
            settings.pull = (parts & 8u) != 0 ? std::optional(Pull{17, {0.1, 0.2, 2.0}}) : std::nullopt;
            if ((parts & 16u) != 0) {
                scene.fill->radius = {0.05, 0.1};
            } else {
                settings.laws.unequal_radii = (parts & 4u) != 0;
                settings.laws.unequal_masses = (parts & 2u) != 0;
            }
            CAPTURE(integrator_names[integrator], parts);
            check_scene(scene, settings, 2, 1);
        }
    }
}

TEST_CASE_METHOD(GlFixture, "a law that declares nothing and is left in disagrees with the mirror", "[gpu-check]") {
    // Those that declare something are noticed by their names (programs_golden_gpu_test).
    struct LeftIn {
        const char* file;
        const char* condition;
    };
    for (const LeftIn& law : {LeftIn{"shared/contact.glsl", "#ifdef LAW_LIMIT_FORCE"},
                              LeftIn{"collide.comp", "#if defined(INTEGRATOR_FORWARD_EULER)"},
                              LeftIn{"collide.comp", "#elif defined(INTEGRATOR_HISTORICAL)"}}) {
        const test::ShaderCopy copy;
        const std::string always = std::string(law.condition).starts_with("#elif") ? "#elif 1" : "#if 1";
        copy.replace(law.file, law.condition, always);
        Scene scene = test::mono_pile_scene(100);
        scene.fill->region = {dvec3(-0.4), dvec3(0.4)};
        scene.settings.limit_force = false;
        Simulation simulation(scene, scene.settings, 1, std::make_unique<gpu::GpuBackend>(copy.path()));
        cpu::CpuBackend<float> mirror;
        CAPTURE(law.condition);
        CHECK_FALSE(measure::check(simulation, mirror, 10).passed());
    }
}

TEST_CASE_METHOD(GlFixture, "balls that are thrown in agree with the mirror", "[gpu-check]") {
    for (const char* laws : {"gravity,drag", "gravity,contact,restitution,walls", "gravity"}) {
        const Scene scene = test::scene_with(laws, 63);
        Simulation simulation(scene, scene.settings, 1, test::gpu_backend());
        simulation.step();
        simulation.apply(AddBalls{
            {{{0, 0, 0}, {1, 2, 3}, 0.3, 9.0, std::nullopt}, {{0.1, 0, 0}, {1, 2, 3}, 0.1, 1.0, std::nullopt}}});
        CAPTURE(laws);
        cpu::CpuBackend<float> mirror;
        expect_agreement(measure::check(simulation, mirror, 2), test::rounds_like_the_cpu(simulation.backend()));
    }
}

TEST_CASE_METHOD(GlFixture, "a ball's own restitution agrees with the mirror", "[gpu-check]") {
    Scene scene = test::shipped_scene("newtons_cradle");
    scene.balls[0].restitution = 0.3;
    scene.balls[1].velocity = {-0.5, 0.1, 0};
    scene.balls[2].restitution = 0.8;
    check_scene(scene, scene.settings, 0, 4);
}

TEST_CASE_METHOD(GlFixture, "balls at the same place agree with the mirror", "[gpu-check]") {
    Scene scene = test::shipped_scene("newtons_cradle");
    for (BallSpec& ball : scene.balls) {
        ball.position = {0.3, -0.2, 0.1};
    }
    check_scene(scene, scene.settings, 0, 2);
}

TEST_CASE_METHOD(GlFixture, "a whole run on the GPU is the mirror's run, to the last bit", "[gpu-check]") {
    const Scene scene = test::shipped_scene("rain");
    Settings settings = scene.settings;
    settings.balls = 500;
    Simulation on_gpu(scene, settings, 42, test::gpu_backend());
    Simulation on_cpu(scene, settings, 42, std::make_unique<cpu::CpuBackend<float>>());
    for (int i = 0; i < 80; ++i) {
        on_gpu.step();
        on_cpu.step();
    }
    if (test::rounds_like_the_cpu(on_gpu.backend())) {
        CHECK(hash_state(on_gpu.raw_state()) == hash_state(on_cpu.raw_state()));
    } else {
        WARN("this device rounds in its own way: only the dispatches are compared, not the run");
    }
    // On any device: the same run twice.
    Simulation again(scene, settings, 42, test::gpu_backend());
    for (int i = 0; i < 80; ++i) {
        again.step();
    }
    CHECK(hash_state(again.raw_state()) == hash_state(on_gpu.raw_state()));
}
