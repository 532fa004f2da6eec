// Settled piles at the edge of stability: what the gauge of dt / dt_c is held to.
#pragma once

#include <cstdint>

#include "core/simulation.h"

namespace ballpit::test {

struct PileKind {
    bool unequal_radii = false;  // 1 : 2, masses 1 : 8
    double restitution = 1.0;
};

/// About `balls` of them, settled under gravity in float; no law takes energy from here on but the restitution.
struct SettledPile {
    Scene scene;
    BallState state;
    double weight_energy = 0.0;  // J, m g times the mean radius, of all balls together
};
SettledPile settled_pile(const PileKind& kind, std::uint32_t balls);

/// The true critical substep (s) of undamped springs: 2 / omega of the fastest mode of the contacts as they are, by
/// power iteration of M^-1/2 K M^-1/2 in double.
double true_critical_dt(const SettledPile& pile);

/// What the gauge says of this substep, dt / dt_c.
double gauge_of(const SettledPile& pile, double dt);

/// The largest kinetic energy of `substeps` of `dt`, over weight_energy; infinite where a ball is not finite.
double agitation(const SettledPile& pile, double dt, int substeps);

}  // namespace ballpit::test
