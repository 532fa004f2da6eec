// Cases with a known answer on the mirror in float and on the reference in double.
#include "support/analytic.h"

#include "cpu/cpu_backend.h"
#include "support/catch.h"

using namespace ballpit;

namespace {

template <class Real>
test::Machine machine() {
    return {[] { return std::make_unique<cpu::CpuBackend<Real>>(); }, std::is_same_v<Real, float> ? 1.0 : 0.0};
}

}  // namespace

TEMPLATE_TEST_CASE("A1 free fall", "[physics]", float, double) { test::a1_free_fall(machine<TestType>()); }
TEMPLATE_TEST_CASE("A2 projectile with drag", "[physics]", float, double) {
    test::a2_projectile_with_drag(machine<TestType>());
}
TEMPLATE_TEST_CASE("A2 apex and range", "[physics]", float, double) { test::a2_apex_and_range(machine<TestType>()); }
TEMPLATE_TEST_CASE("A3 terminal velocity", "[physics]", float, double) {
    test::a3_terminal_velocity(machine<TestType>());
}
TEMPLATE_TEST_CASE("A4 head-on collision", "[physics]", float, double) { test::a4_head_on(machine<TestType>()); }
TEMPLATE_TEST_CASE("A4 contacts of no whole number of substeps", "[physics]", float, double) {
    test::a4_contact_of_no_whole_number_of_substeps(machine<TestType>());
}
TEMPLATE_TEST_CASE("A5 unequal balls", "[physics]", float, double) { test::a5_unequal_balls(machine<TestType>()); }
TEMPLATE_TEST_CASE("A6 bounces on the floor", "[physics]", float, double) {
    test::a6_bounces_on_the_floor(machine<TestType>());
}
TEMPLATE_TEST_CASE("A6 with compensated sums", "[physics]", float, double) {
    test::a6_with_compensated_sums(machine<TestType>());
}
TEMPLATE_TEST_CASE("A6 touch and depth", "[physics]", float, double) { test::a6_touch_and_depth(machine<TestType>()); }
TEMPLATE_TEST_CASE("A7, A8 restitution with a dashpot", "[physics]", float, double) {
    test::a7_a8_restitution_with_dashpot(machine<TestType>());
}
TEMPLATE_TEST_CASE("A9 static overlap", "[physics]", float, double) { test::a9_static_overlap(machine<TestType>()); }
TEMPLATE_TEST_CASE("A10 column at rest", "[physics]", float, double) { test::a10_column_at_rest(machine<TestType>()); }
TEMPLATE_TEST_CASE("A10 column at the limit of stability", "[physics]", float, double) {
    test::a10_column_at_the_stability_limit(machine<TestType>());
}
TEMPLATE_TEST_CASE("A12 oscillation in contact", "[physics]", float, double) {
    test::a12_oscillation_in_contact(machine<TestType>());
}
TEMPLATE_TEST_CASE("A13 kicked chain", "[physics]", float, double) { test::a13_kicked_chain(machine<TestType>()); }
TEMPLATE_TEST_CASE("A14 Newton's cradle", "[physics]", float, double) { test::a14_newtons_cradle(machine<TestType>()); }
TEMPLATE_TEST_CASE("A15 oblique scattering", "[physics]", float, double) {
    test::a15_oblique_scattering(machine<TestType>());
}
TEMPLATE_TEST_CASE("A15 oblique with a dashpot", "[physics]", float, double) {
    test::a15_oblique_with_dashpot(machine<TestType>());
}
TEMPLATE_TEST_CASE("A16 corner", "[physics]", float, double) { test::a16_corner(machine<TestType>()); }
TEMPLATE_TEST_CASE("A25 forces of all neighbours", "[physics]", float, double) {
    test::a25_neighbours(machine<TestType>());
}
TEMPLATE_TEST_CASE("A25 cells of a scene", "[physics]", float, double) {
    test::a25_grid_of_a_scene(machine<TestType>());
}
TEMPLATE_TEST_CASE("A26 mirror, rotation, permutation", "[physics]", float, double) {
    test::a26_mirror_rotation_permutation(machine<TestType>());
}
TEMPLATE_TEST_CASE("A26 translation and boost", "[physics]", float, double) {
    test::a26_translation_and_boost(machine<TestType>());
}
TEMPLATE_TEST_CASE("A27 time reversal", "[physics]", float, double) { test::a27_time_reversal(machine<TestType>()); }
TEMPLATE_TEST_CASE("A28 conservation", "[physics]", float, double) { test::a28_conservation(machine<TestType>()); }

TEMPLATE_TEST_CASE("order of free flight", "[orders]", float, double) {
    test::order_of_free_flight(machine<TestType>());
}
TEMPLATE_TEST_CASE("order of elastic restitution", "[orders]", float, double) {
    test::order_of_elastic_restitution(machine<TestType>());
}
TEMPLATE_TEST_CASE("order of damped restitution", "[orders]", float, double) {
    test::order_of_damped_restitution(machine<TestType>());
}
TEMPLATE_TEST_CASE("order of bounces", "[orders]", float, double) { test::order_of_bounces(machine<TestType>()); }
TEMPLATE_TEST_CASE("order of a chain", "[orders]", float, double) { test::order_of_chain(machine<TestType>()); }
