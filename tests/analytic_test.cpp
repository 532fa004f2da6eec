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
TEMPLATE_TEST_CASE("A3 terminal velocity", "[physics]", float, double) {
    test::a3_terminal_velocity(machine<TestType>());
}
TEMPLATE_TEST_CASE("A4 head-on collision", "[physics]", float, double) { test::a4_head_on(machine<TestType>()); }
TEST_CASE("A4 order of convergence, on the reference", "[physics]") {
    test::a4_order_of_convergence(machine<double>());
}
TEMPLATE_TEST_CASE("A5 unequal balls", "[physics]", float, double) { test::a5_unequal_balls(machine<TestType>()); }
TEMPLATE_TEST_CASE("A7, A8 restitution with a dashpot", "[physics]", float, double) {
    test::a8_restitution_with_dashpot(machine<TestType>());
}
TEMPLATE_TEST_CASE("A9 static overlap", "[physics]", float, double) { test::a9_static_overlap(machine<TestType>()); }
TEMPLATE_TEST_CASE("A14 Newton's cradle", "[physics]", float, double) { test::a14_newtons_cradle(machine<TestType>()); }
TEMPLATE_TEST_CASE("A16 corner", "[physics]", float, double) { test::a16_corner(machine<TestType>()); }
