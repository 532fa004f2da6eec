// Cases with a known answer on the GPU.
#include "support/analytic.h"
#include "support/catch.h"
#include "support/gl_fixture.h"
#include "support/gpu_backend.h"

using namespace ballpit;
using test::GlFixture;

namespace {

test::Machine machine() {
    return {[] { return test::gpu_backend(); }, 1.0};
}

}  // namespace

TEST_CASE_METHOD(GlFixture, "A1 free fall on the GPU", "[gpu-physics]") { test::a1_free_fall(machine()); }
TEST_CASE_METHOD(GlFixture, "A2 projectile with drag on the GPU", "[gpu-physics]") {
    test::a2_projectile_with_drag(machine());
}
TEST_CASE_METHOD(GlFixture, "A3 terminal velocity on the GPU", "[gpu-physics]") {
    test::a3_terminal_velocity(machine());
}
TEST_CASE_METHOD(GlFixture, "A4 head-on collision on the GPU", "[gpu-physics]") { test::a4_head_on(machine()); }
TEST_CASE_METHOD(GlFixture, "A5 unequal balls on the GPU", "[gpu-physics]") { test::a5_unequal_balls(machine()); }
TEST_CASE_METHOD(GlFixture, "A9 static overlap on the GPU", "[gpu-physics]") { test::a9_static_overlap(machine()); }
TEST_CASE_METHOD(GlFixture, "A14 Newton's cradle on the GPU", "[gpu-physics]") { test::a14_newtons_cradle(machine()); }
TEST_CASE_METHOD(GlFixture, "A16 corner on the GPU", "[gpu-physics]") { test::a16_corner(machine()); }
