// Stepping forth and back on the GPU.
#include "core/stepper.h"

#include "gpu/gpu_backend.h"
#include "support/catch.h"
#include "support/gl_fixture.h"
#include "support/stepping.h"

using namespace ballpit;
using namespace ballpit::test;

namespace {

std::unique_ptr<Backend> gpu_backend() { return std::make_unique<gpu::GpuBackend>(BALLPIT_SOURCE_DIR "/glsl"); }

}  // namespace

TEST_CASE_METHOD(GlFixture, "GPU: back in every unit from every dispatch gives the bytes of the way there",
                 "[stepper]") {
    for (const SortMethod sort : {SortMethod::bitonic, SortMethod::bitonic_fused, SortMethod::counting}) {
        Simulation simulation = stepping_simulation(gpu_backend(), sort);
        check_every_position(simulation);
    }
}

TEST_CASE_METHOD(GlFixture, "GPU: whatever was done on the way, back and forth give the bytes of the way there",
                 "[stepper]") {
    Simulation simulation = stepping_simulation(gpu_backend(), SortMethod::bitonic_fused);
    check_changes_at_every_position(simulation);
}

TEST_CASE_METHOD(GlFixture, "GPU: 300 steps with changes on the way, back and forth, end on the same hash",
                 "[stepper]") {
    Simulation simulation = stepping_simulation(gpu_backend(), SortMethod::bitonic_fused);
    check_long_way(simulation, 300);
}

TEST_CASE_METHOD(GlFixture, "the GPU's state hash is the one of the bytes, also when nobody takes hundreds of them",
                 "[stepper]") {
    Simulation simulation = stepping_simulation(gpu_backend(), SortMethod::bitonic_fused);
    std::vector<std::uint64_t> expected;
    for (std::uint64_t i = 0; i < 300; ++i) {
        simulation.substep();
        simulation.backend().request_hash(i);
        expected.push_back(hash_state(simulation.raw_state()));
    }
    std::vector<TaggedHash> taken;
    for (int tries = 0; tries < 10 && taken.size() < expected.size(); ++tries) {
        simulation.backend().finish();
        const auto some = simulation.backend().take_hashes();
        taken.insert(taken.end(), some.begin(), some.end());
    }
    REQUIRE(taken.size() == expected.size());
    for (std::size_t i = 0; i < taken.size(); ++i) {
        CHECK(taken[i].tag == i);
        CHECK(taken[i].hash == expected[i]);
    }
}
