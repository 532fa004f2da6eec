// What the verification cases expect: closed forms, quadratures and step-by-step predictions, all in double and written
// from the laws of motion alone. Nothing here asks the program's own code for physics.
#pragma once

#include <utility>
#include <vector>

#include "core/integrator.h"

namespace ballpit::test {

/// One coordinate, stepped as the name of the integrator promises: what it must give, truncation error included
/// ("discrete oracle"). `lag` (s): how far v stands behind x.
struct DiscreteLine {
    double x = 0.0;
    double v = 0.0;
    double lag = 0.0;

    /// `acceleration(x, v)` in m/s^2, without drag; `drag` in 1/s.
    template <class Acceleration>
    void step(Integrator integrator, double dt, double drag, const Acceleration& acceleration) {
        const double a = acceleration(x, v);
        const double old = v;
        const bool staggered = integrator == Integrator::leapfrog || integrator == Integrator::velocity_verlet;
        kick(staggered ? lag + 0.5 * dt : dt, drag, a);
        lag = staggered ? 0.5 * dt : 0.0;
        if (integrator == Integrator::forward_euler) {
            x += dt * old;
        } else if (integrator == Integrator::historical) {
            x += dt * old + 0.5 * dt * dt * a;
        } else {
            x += dt * v;
        }
    }

    /// v at the time of x.
    template <class Acceleration>
    double synchronised(double drag, const Acceleration& acceleration) const {
        DiscreteLine copy = *this;
        copy.kick(lag, drag, acceleration(x, v));
        return copy.v;
    }

private:
    void kick(double duration, double drag, double a);
};

/// Spring and dashpot against a wall at x = 0; the ball's near side is at x. N and kg.
struct SpringContact {
    double stiffness = 1e4;
    double mass = 1.0;  // effective: of a pair m1 m2 / (m1 + m2)
    double damping_ratio = 0.0;
    bool limit_force = true;
    double gravity = 0.0;  // m/s^2, towards positive x

    double operator()(double x, double v) const;
    double frequency() const;  // rad/s
};

/// Restitution of a linear spring and dashpot; without `limit_force` the contact ends at x = 0, with it where the
/// force vanishes (Schwager and Poeschel 2007).
double exact_restitution(double damping_ratio, bool limit_force);
/// Phase w t at which that contact ends.
double exact_contact_phase(double damping_ratio, bool limit_force);

/// A ball bouncing without loss: distance of its lowest point from the floor, and its velocity, `t` s after it was let
/// go at `height` (m). Spring of frequency `w` (rad/s), gravity `g` > 0.
std::pair<double, double> bouncing(double height, double w, double g, double t);

/// Bessel function J_n(x), from Bessel's integral; the trapezoidal rule is exact to rounding for a periodic integrand.
double bessel_j(int n, double x);

/// Velocities after a row of `balls` equal touching balls was struck by its first (1 m/s), as long as they touch and
/// beyond: Runge-Kutta of fourth order with 1/3000 of a contact. Spring of 1 N/m between masses of 1 kg.
std::vector<double> cradle_velocities(int balls);

/// The same as an integrator with n substeps a contact gives it.
std::vector<double> discrete_cradle(int balls, Integrator integrator, int n);

/// Two equal balls of mass 1 kg meet at +-1 m/s with an impact parameter b below their distance of contact D (m).
struct Scattering {
    double angle;        // rad, by which the relative velocity turns
    double max_overlap;  // m
    double duration;     // s
};
Scattering scattering(double stiffness, double reach, double impact_parameter);

}  // namespace ballpit::test
