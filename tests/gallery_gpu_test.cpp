// Every scene that ships runs 600 steps on the GPU, finite and inside its bounds.
#include "support/catch.h"
#include "support/gallery.h"
#include "support/gl_fixture.h"
#include "support/gpu_backend.h"

using namespace ballpit;
using test::GlFixture;

TEST_CASE_METHOD(GlFixture, "every scene of the gallery keeps its bounds on the GPU, with few balls", "[gpu-gallery]") {
    test::gallery_keeps_its_bounds(test::gpu_backend, test::few_balls, false);
}

// Minutes where a CPU plays the GPU: `./run gallery`.
TEST_CASE_METHOD(GlFixture, "every scene of the gallery keeps its bounds on the GPU", "[.][gallery-full]") {
    test::gallery_keeps_its_bounds(test::gpu_backend, maximum_balls, true);
}
