// The meters of the GPU: the same numbers as the mirror's, late, and no bit of the physics changed.
#include "support/catch.h"
#include "support/gl_fixture.h"
#include "support/gpu_backend.h"
#include "support/meter_contract.h"

using namespace ballpit;
using test::GlFixture;

TEST_CASE_METHOD(GlFixture, "the GPU's readings agree with the mirror's", "[gpu-meter]") {
    test::readings_agree_with_the_mirror([] { return test::gpu_backend(); });
}

TEST_CASE_METHOD(GlFixture, "the GPU's readings arrive in order, the same in every run", "[gpu-meter]") {
    test::readings_arrive_in_order([] { return test::gpu_backend(); });
}

TEST_CASE_METHOD(GlFixture, "metering changes nothing on the GPU", "[gpu-meter]") {
    test::metering_changes_nothing([] { return test::gpu_backend(); });
}
