// Every scene that ships runs 600 steps on the mirror, finite and inside its bounds.
#include "support/gallery.h"
#include "cpu/cpu_backend.h"
#include "support/catch.h"

using namespace ballpit;

namespace {

std::unique_ptr<Backend> mirror() { return std::make_unique<cpu::CpuBackend<float>>(); }

}  // namespace

TEST_CASE("every scene of the gallery keeps its bounds on the mirror, with few balls", "[gallery]") {
    test::gallery_keeps_its_bounds(mirror, test::few_balls, false);
}

// Minutes: `./run gallery`.
TEST_CASE("every scene of the gallery keeps its bounds on the mirror", "[.][gallery-full]") {
    test::gallery_keeps_its_bounds(mirror, maximum_balls, true);
}
