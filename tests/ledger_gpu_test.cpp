// The ledger against the device: bytes that are allocated, barriers that are issued, buffers that are bound.
#include "core/ledger.h"

#include <numeric>

#include "core/scene_schedule.h"
#include "core/simulation.h"
#include "support/catch.h"
#include "support/gl_fixture.h"
#include "support/gpu_backend.h"
#include "support/law_scenes.h"
#include "support/shader_copy.h"
#include "support/unread_contract.h"

using namespace ballpit;
using test::GlFixture;

namespace {

void check_against_ledger(const Scene& scene, std::uint64_t seed) {
    auto owned = test::gpu_backend();
    const gpu::GpuBackend& backend = *owned;
    Simulation simulation(scene, scene.settings, seed, std::move(owned));
    const auto bytes = bytes_of(simulation.schedule());
    CHECK(backend.allocated_bytes() == std::accumulate(bytes.begin(), bytes.end(), std::size_t{0}));
    for (std::size_t i = 0; i < slot_count; ++i) {
        CAPTURE(slot_names[i]);
        CHECK(simulation.backend().read(static_cast<Slot>(i)).size() == bytes[i]);
    }
    simulation.substep();
    simulation.substep();
    const BarrierCount told = count_barriers(simulation.schedule());
    for (int i = 0; i < 3; ++i) {
        const std::uint64_t before = backend.barriers_issued();
        simulation.substep();
        CHECK(backend.barriers_issued() - before == told.before + told.within);
    }
}

}  // namespace

TEST_CASE_METHOD(GlFixture, "the GPU allocates and waits as the ledger of every scene tells", "[gpu-ledger]") {
    for (const std::string_view name : test::shipped_scene_names) {
        CAPTURE(name);
        const Scene scene = test::shipped_scene(name);
        check_against_ledger(scene, test::seed_of(scene));
    }
}

TEST_CASE_METHOD(GlFixture, "the GPU allocates and waits as the ledger of minimal scenes tells", "[gpu-ledger]") {
    for (const Scene& scene :
         {test::free_fall_scene(3000), test::elastic_gas_scene(200), test::mono_pile_scene(200),
          test::mixed_pile_scene(200), test::scene_with("gravity,ball_restitution", 65),
          test::scene_with("gravity,walls,ball_restitution", 65), test::scene_with("gravity,compensated", 65),
          test::scene_with("contact,restitution,walls,compensated", 65)}) {
        CAPTURE(scene.name);
        check_against_ledger(scene, 1);
    }
}

TEST_CASE_METHOD(GlFixture, "the GPU reads of other balls only what counts", "[gpu-ledger]") {
    test::reads_only_what_counts(*test::gpu_backend());
}

TEST_CASE_METHOD(GlFixture, "a shader that reads what it could do without is noticed", "[gpu-ledger]") {
    const test::ShaderCopy radius;
    radius.replace("shared/contact.glsl", "return params.radius;", "return position.w;");
    gpu::GpuBackend reads_radius(radius.path());
    CHECK(test::changed_by_radii_and_masses(reads_radius, test::Crowd::elastic_gas) > 10);
    const test::ShaderCopy mass;
    mass.replace("shared/contact.glsl", "return params.mass;", "return velocity.w;");
    gpu::GpuBackend reads_mass(mass.path());
    CHECK(test::changed_by_radii_and_masses(reads_mass, test::Crowd::mono_pile) > 10);
    const test::ShaderCopy velocity;
    velocity.replace("shared/pair.glsl", "return spring_force(overlap);",
                     "return spring_force(overlap) + 1e-30 * velocities[place].x;");
    gpu::GpuBackend reads_velocity(velocity.path());
    CHECK(test::changed_by_other_velocities(reads_velocity, test::Crowd::elastic_gas) > 10);
}
