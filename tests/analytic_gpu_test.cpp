// Cases with a known answer on the GPU.
#include "support/analytic.h"
#include "support/catch.h"
#include "support/gl_fixture.h"
#include "support/gpu_backend.h"

using namespace ballpit;
using test::GlFixture;

namespace {

test::Machine machine() {
    return {[] { return test::gpu_backend(); }, 1.0, true};
}

}  // namespace

TEST_CASE_METHOD(GlFixture, "A1 free fall on the GPU", "[gpu-physics]") { test::a1_free_fall(machine()); }
TEST_CASE_METHOD(GlFixture, "A2 projectile with drag on the GPU", "[gpu-physics]") {
    test::a2_projectile_with_drag(machine());
}
TEST_CASE_METHOD(GlFixture, "A2 apex and range on the GPU", "[gpu-physics]") { test::a2_apex_and_range(machine()); }
TEST_CASE_METHOD(GlFixture, "A3 terminal velocity on the GPU", "[gpu-physics]") {
    test::a3_terminal_velocity(machine());
}
TEST_CASE_METHOD(GlFixture, "A4 head-on collision on the GPU", "[gpu-physics]") { test::a4_head_on(machine()); }
TEST_CASE_METHOD(GlFixture, "A4 contacts of no whole number of substeps on the GPU", "[gpu-physics]") {
    test::a4_contact_of_no_whole_number_of_substeps(machine());
}
TEST_CASE_METHOD(GlFixture, "A5 unequal balls on the GPU", "[gpu-physics]") { test::a5_unequal_balls(machine()); }
TEST_CASE_METHOD(GlFixture, "A6 bounces on the floor on the GPU", "[gpu-physics]") {
    test::a6_bounces_on_the_floor(machine());
}
TEST_CASE_METHOD(GlFixture, "A6 with compensated sums on the GPU", "[gpu-physics]") {
    test::a6_with_compensated_sums(machine());
}
TEST_CASE_METHOD(GlFixture, "A6 touch and depth on the GPU", "[gpu-physics]") { test::a6_touch_and_depth(machine()); }
TEST_CASE_METHOD(GlFixture, "A7, A8 restitution with a dashpot on the GPU", "[gpu-physics]") {
    test::a7_a8_restitution_with_dashpot(machine());
}
TEST_CASE_METHOD(GlFixture, "A9 static overlap on the GPU", "[gpu-physics]") { test::a9_static_overlap(machine()); }
TEST_CASE_METHOD(GlFixture, "A10 column at rest on the GPU", "[gpu-physics]") { test::a10_column_at_rest(machine()); }
TEST_CASE_METHOD(GlFixture, "A10 column at the limit of stability on the GPU", "[gpu-physics]") {
    test::a10_column_at_the_stability_limit(machine());
}
TEST_CASE_METHOD(GlFixture, "A12 oscillation in contact on the GPU", "[gpu-physics]") {
    test::a12_oscillation_in_contact(machine());
}
TEST_CASE_METHOD(GlFixture, "A13 kicked chain on the GPU", "[gpu-physics]") { test::a13_kicked_chain(machine()); }
TEST_CASE_METHOD(GlFixture, "A14 Newton's cradle on the GPU", "[gpu-physics]") { test::a14_newtons_cradle(machine()); }
TEST_CASE_METHOD(GlFixture, "A15 oblique scattering on the GPU", "[gpu-physics]") {
    test::a15_oblique_scattering(machine());
}
TEST_CASE_METHOD(GlFixture, "A15 oblique with a dashpot on the GPU", "[gpu-physics]") {
    test::a15_oblique_with_dashpot(machine());
}
TEST_CASE_METHOD(GlFixture, "A16 corner on the GPU", "[gpu-physics]") { test::a16_corner(machine()); }
TEST_CASE_METHOD(GlFixture, "A25 forces of all neighbours on the GPU", "[gpu-physics]") {
    test::a25_neighbours(machine());
}
TEST_CASE_METHOD(GlFixture, "A25 cells of a scene on the GPU", "[gpu-physics]") {
    test::a25_grid_of_a_scene(machine());
}
TEST_CASE_METHOD(GlFixture, "A26 mirror, rotation, permutation on the GPU", "[gpu-physics]") {
    test::a26_mirror_rotation_permutation(machine());
}
TEST_CASE_METHOD(GlFixture, "A26 translation and boost on the GPU", "[gpu-physics]") {
    test::a26_translation_and_boost(machine());
}
TEST_CASE_METHOD(GlFixture, "A27 time reversal on the GPU", "[gpu-physics]") { test::a27_time_reversal(machine()); }
TEST_CASE_METHOD(GlFixture, "A28 conservation on the GPU", "[gpu-physics]") { test::a28_conservation(machine()); }
