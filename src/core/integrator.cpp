#include "core/integrator.h"

#include <cmath>

namespace ballpit {

Kick make_kick(double drag, double duration) {
    const double exponent = -drag * duration;
    // expm1 keeps the gain accurate where drag * duration is tiny; its limit is the duration itself.
    const double gain = exponent == 0.0 ? duration : std::expm1(exponent) / -drag;
    return {std::exp(exponent), gain, std::expm1(exponent)};
}

SubstepMotion substep_motion(Integrator integrator, double drag, double dt, double velocity_lag) {
    const double half = 0.5 * dt;
    switch (integrator) {
        case Integrator::leapfrog:
            return {make_kick(drag, velocity_lag + half), {}, dt, half};
        case Integrator::velocity_verlet:
            return {make_kick(drag, velocity_lag), make_kick(drag, half), dt, half};
        case Integrator::symplectic_euler:
        case Integrator::forward_euler:
        case Integrator::historical:
            break;
    }
    return {make_kick(drag, dt), {}, dt, 0.0};
}

SubstepMotion synchronising_motion(double drag, double velocity_lag) {
    return {make_kick(drag, velocity_lag), {}, 0.0, 0.0};
}

}  // namespace ballpit
