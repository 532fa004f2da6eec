// Contact law: linear spring and dashpot along the line of centres, F = k * overlap - c * v_n.
// The dashpot is given by the restitution e through its damping ratio zeta = c / (2 sqrt(k m_eff)),
// which depends on e alone: one number serves every pair of masses.
#pragma once

#include <span>
#include <vector>

namespace ballpit {

/// Smallest restitution that the explicit dashpot can be asked for (zeta 1.95 when the force is limited).
inline constexpr double minimum_restitution = 0.05;

/// A semi-implicit dashpot has c / (1 + share * c dt / m_eff) in place of c. With share 1 this is what takes a
/// pair's speed of separation from v to v / (1 + c dt / m_eff), the implicit Euler step of its dashpot alone: it never
/// turns the speed round. A ball with many contacts gets that from each of them. What is safe then follows from
/// M - dt C / 2 > 0 (measure/stability.h): with dt c <= m_eff / share, dt C / 2 is at most M times the largest
/// eigenvalue of sum (2 m_eff / m) n n^T over 2 share, which is 4 / (2 share) among the twelve equal neighbours of a
/// densest packing; hence 2. docs/extremes.md has the derivation, and why not each ball's own implicit step.
inline constexpr double semi_implicit_share = 2.0;

/// Restitution e of one collision against the damping ratio zeta >= 0, gravity neglected.
/// With `limit_force` the contact ends when the force would pull (Schwager and Poeschel 2007, Granular
/// Matter 9, eq. 21); without, when the overlap returns to zero, e = exp(-pi zeta / sqrt(1 - zeta^2)).
double restitution_from_damping_ratio(double zeta, bool limit_force);

/// How long that contact lasts, in units of 1/w with w = sqrt(k / m_eff): e = exp(-zeta * this), since what is left of
/// the speed when the force ends is that of the decaying oscillation. Infinite for zeta >= 1 where the force is not
/// limited.
double contact_duration(double zeta, bool limit_force);

/// The largest overlap of a collision at speed v, in units of v/w: where the speed of the decaying oscillation
/// x(t) = v/(w s) exp(-zeta w t) sin(s w t), s = sqrt(1 - zeta^2), vanishes, which is at s w t = acos(zeta).
double largest_overlap(double zeta);

/// Inverse of restitution_from_damping_ratio, by bisection to 1e-15 in zeta. e >= 1 gives 0. Expects e >=
/// minimum_restitution.
double damping_ratio_from_restitution(double e, bool limit_force);

/// One for each ball, rounded to single: what the shaders read.
std::vector<float> damping_ratios_of(std::span<const double> restitutions, bool limit_force);

}  // namespace ballpit
