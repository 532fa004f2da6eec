// Kicks and drifts: exact for constant acceleration and linear drag, and the lag that leapfrog keeps.
#include "core/integrator.h"

#include <cmath>

#include "support/catch.h"

using namespace ballpit;

namespace {

double kicked(double v, double a, const Kick& kick) { return kick.decay * v + kick.gain * a; }

}  // namespace

TEST_CASE("a kick without drag is the bare duration", "[core]") {
    for (const double duration : {0.0, 1e-9, 1.0 / 480.0, 1.0}) {
        const Kick kick = make_kick(0.0, duration);
        CHECK(kick.decay == 1.0);
        CHECK(kick.gain == duration);
    }
}

TEST_CASE("a kick with drag is the exact solution", "[core]") {
    // dv/dt = a - drag v: v(t) = a/drag + (v0 - a/drag) exp(-drag t)
    for (const double drag : {1e-12, 1e-3, 0.1, 5.0, 100.0}) {
        for (const double t : {1e-6, 1.0 / 480.0, 0.5}) {
            const double exact = 3.0 * std::exp(-drag * t) - 9.8 * -std::expm1(-drag * t) / drag;
            CAPTURE(drag, t);
            CHECK(kicked(3.0, -9.8, make_kick(drag, t)) == Approx(exact).epsilon(1e-14));
        }
    }
}

TEST_CASE("two kicks are one kick of both durations", "[core]") {
    const double once = kicked(2.0, -9.8, make_kick(0.3, 0.75));
    const double twice = kicked(kicked(2.0, -9.8, make_kick(0.3, 0.5)), -9.8, make_kick(0.3, 0.25));
    CHECK(twice == Approx(once).epsilon(1e-15));
}

TEST_CASE("leapfrog starts with half a kick and then keeps half a substep of lag", "[core]") {
    const SubstepMotion first = substep_motion(Integrator::leapfrog, 0.0, 0.01, 0.0);
    CHECK(first.first.gain == Approx(0.005).epsilon(1e-15));
    CHECK(first.lag_after == 0.005);
    CHECK(first.drift == 0.01);
    const SubstepMotion next = substep_motion(Integrator::leapfrog, 0.0, 0.01, first.lag_after);
    CHECK(next.first.gain == Approx(0.01).epsilon(1e-15));
    CHECK(next.lag_after == 0.005);
    // A new dt in the middle: half of the old one and half of the new one.
    CHECK(substep_motion(Integrator::leapfrog, 0.0, 0.03, 0.005).first.gain == Approx(0.02).epsilon(1e-15));
    CHECK(synchronising_motion(0.0, 0.005).first.gain == 0.005);
    CHECK(synchronising_motion(0.0, 0.005).drift == 0.0);
}

TEST_CASE("velocity Verlet is leapfrog's kick in two parts", "[core]") {
    const SubstepMotion verlet = substep_motion(Integrator::velocity_verlet, 0.2, 0.01, 0.005);
    const SubstepMotion leapfrog = substep_motion(Integrator::leapfrog, 0.2, 0.01, 0.005);
    CHECK(verlet.lag_after == leapfrog.lag_after);
    CHECK(kicked(kicked(1.0, 2.0, verlet.first), 2.0, verlet.second) ==
          Approx(kicked(1.0, 2.0, leapfrog.first)).epsilon(1e-15));
}

TEST_CASE("the Euler integrators kick once and leave no lag", "[core]") {
    for (const Integrator each : {Integrator::symplectic_euler, Integrator::forward_euler, Integrator::historical}) {
        const SubstepMotion motion = substep_motion(each, 0.0, 0.01, 0.0);
        CHECK(motion.first.gain == 0.01);
        CHECK(motion.drift == 0.01);
        CHECK(motion.lag_after == 0.0);
    }
}
