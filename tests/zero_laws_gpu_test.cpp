// A law with a coefficient of zero is no law, to the last bit: the shaders.
#include "support/catch.h"
#include "support/gl_fixture.h"
#include "support/gpu_backend.h"
#include "support/zero_laws.h"

using namespace ballpit;
using test::GlFixture;

TEST_CASE_METHOD(GlFixture, "GPU: a law that is compiled in and does nothing changes no bit of a run",
                 "[gpu-zero-laws]") {
    // One dispatch a substep instead of five makes the others bearable where there is no GPU.
    test::zero_laws_change_no_bit([] { return test::gpu_backend(); }, Integrator::leapfrog, NeighbourSearch::grid);
    for (std::size_t i = 0; i < integrator_names.size(); ++i) {
        test::zero_laws_change_no_bit([] { return test::gpu_backend(); }, static_cast<Integrator>(i),
                                      NeighbourSearch::brute_force);
    }
}
