#include "support/oracle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace ballpit::test {

using std::numbers::pi;

void DiscreteLine::kick(double duration, double drag, double a) {
    if (drag == 0.0) {
        v += duration * a;
    } else {
        const double decay = std::exp(-drag * duration);
        v = decay * v + (1.0 - decay) / drag * a;
    }
}

double SpringContact::operator()(double x, double v) const {
    if (x >= 0.0) {
        return gravity;
    }
    const double c = 2.0 * damping_ratio * std::sqrt(stiffness * mass);
    const double force = -stiffness * x - c * v;
    return gravity + (limit_force && force < 0.0 ? 0.0 : force) / mass;
}

double SpringContact::frequency() const { return std::sqrt(stiffness / mass); }

double exact_contact_phase(double damping_ratio, bool limit_force) {
    const double s = std::sqrt(1.0 - damping_ratio * damping_ratio);
    if (!limit_force) {
        return pi / s;
    }
    return (pi - std::atan2(2.0 * damping_ratio * s, 1.0 - 2.0 * damping_ratio * damping_ratio)) / s;
}

// Overlap e^(-zeta wt) sin(s wt) / s: its velocity at the end is e^(-zeta wt) in both cases.
double exact_restitution(double damping_ratio, bool limit_force) {
    return std::exp(-damping_ratio * exact_contact_phase(damping_ratio, limit_force));
}

std::pair<double, double> bouncing(double height, double w, double g, double t) {
    const double speed = std::sqrt(2.0 * g * height);
    const double sag = g / (w * w);
    const double radius = std::hypot(sag, speed / w);
    const double angle = std::atan2(speed / w, sag);
    const double contact = (2.0 * pi - 2.0 * angle) / w;
    const double flight = 2.0 * speed / g;
    t = std::fmod(t + 0.5 * flight, flight + contact);  // counted from a lift-off
    if (t < flight) {
        return {speed * t - 0.5 * g * t * t, speed - g * t};
    }
    const double phase = angle + w * (t - flight);
    return {-sag + radius * std::cos(phase), -radius * w * std::sin(phase)};
}

double bessel_j(int n, double x) {
    constexpr int points = 400;
    double sum = 0.0;
    for (int i = 0; i < points; ++i) {
        const double angle = 2.0 * pi * i / points;
        sum += std::cos(n * angle - x * std::sin(angle));
    }
    return sum / points;
}

namespace {

// Positions are displacements from where the balls touch; accelerations of springs that only push.
void cradle_accelerations(const std::vector<double>& x, std::vector<double>& a) {
    std::ranges::fill(a, 0.0);
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
        const double force = std::max(x[i] - x[i + 1], 0.0);
        a[i] -= force;
        a[i + 1] += force;
    }
}

}  // namespace

std::vector<double> cradle_velocities(int balls) {
    const auto n = static_cast<std::size_t>(balls);
    const double contact = pi / std::numbers::sqrt2;
    const double dt = contact / 3000.0;
    std::vector<double> x(n, 0.0), v(n, 0.0), trial(n), a(n);
    v[0] = 1.0;
    const auto steps = static_cast<int>(2.0 * (balls + 2) * 3000.0);
    for (int step = 0; step < steps; ++step) {
        constexpr std::array along = {0.0, 0.5, 0.5, 1.0};
        constexpr std::array weight = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
        std::vector<double> dx(n, 0.0), dv(n, 0.0), rate_x(n, 0.0), rate_v(n, 0.0);
        for (std::size_t stage = 0; stage < 4; ++stage) {
            for (std::size_t i = 0; i < n; ++i) {
                trial[i] = x[i] + along[stage] * dt * rate_x[i];
            }
            for (std::size_t i = 0; i < n; ++i) {
                rate_x[i] = v[i] + along[stage] * dt * rate_v[i];
            }
            cradle_accelerations(trial, a);
            for (std::size_t i = 0; i < n; ++i) {
                rate_v[i] = a[i];
                dx[i] += weight[stage] * dt * rate_x[i];
                dv[i] += weight[stage] * dt * rate_v[i];
            }
        }
        for (std::size_t i = 0; i < n; ++i) {
            x[i] += dx[i];
            v[i] += dv[i];
        }
    }
    return v;
}

std::vector<double> discrete_cradle(int balls, Integrator integrator, int n) {
    const auto count = static_cast<std::size_t>(balls);
    const double dt = pi / std::numbers::sqrt2 / n;
    std::vector<DiscreteLine> row(count);
    row[0].v = 1.0;
    std::vector<double> x(count), a(count);
    const auto accelerate = [&] {
        std::ranges::transform(row, x.begin(), &DiscreteLine::x);
        cradle_accelerations(x, a);
    };
    for (int step = 0; step < 2 * (balls + 2) * n; ++step) {
        accelerate();
        for (std::size_t i = 0; i < count; ++i) {
            row[i].step(integrator, dt, 0.0, [&](double, double) { return a[i]; });
        }
    }
    accelerate();
    std::vector<double> v(count);
    for (std::size_t i = 0; i < count; ++i) {
        v[i] = row[i].synchronised(0.0, [&](double, double) { return a[i]; });
    }
    return v;
}

Scattering scattering(double stiffness, double reach, double impact_parameter) {
    const double b = impact_parameter;
    // Energy of the relative motion: m_eff g^2 / 2 with m_eff = 1/2 kg, g = 2 m/s.
    const auto radial = [&](double r) { return 1.0 - b * b / (r * r) - 0.5 * stiffness * (reach - r) * (reach - r); };
    double inside = 0.0;
    double outside = reach;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (inside + outside);
        (radial(middle) > 0.0 ? outside : inside) = middle;
    }
    const double nearest = outside;
    // r = nearest + (reach - nearest) u^2 takes the root out of the integrand; midpoints of u are then smooth to the
    // power of two, so that one Richardson step is enough.
    const auto integrals = [&](int points) {
        std::pair<double, double> sum{0.0, 0.0};
        for (int i = 0; i < points; ++i) {
            const double u = (i + 0.5) / points;
            const double r = nearest + (reach - nearest) * u * u;
            const double dr = 2.0 * (reach - nearest) * u / points;
            const double root = std::sqrt(radial(r));
            sum.first += dr * b / (r * r * root);
            sum.second += dr / (2.0 * root);
        }
        return sum;
    };
    const auto coarse = integrals(4000);
    const auto fine = integrals(8000);
    const double turned = std::asin(b / reach) + (4.0 * fine.first - coarse.first) / 3.0;
    return {pi - 2.0 * turned, reach - nearest, 2.0 * (4.0 * fine.second - coarse.second) / 3.0};
}

}  // namespace ballpit::test
