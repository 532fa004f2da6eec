// What collide must not read: poison put there changes no bit of the result.
#pragma once

#include "core/backend.h"

namespace ballpit::test {

/// The laws, with which a few hundred balls crowd and push each other.
enum class Crowd { elastic_gas, mono_pile, mixed_pile };

/// How many balls (of 58 that are looked at) come out of a substep otherwise when the velocities of all others are NaN.
int changed_by_other_velocities(Backend& backend, Crowd crowd);
/// The same when all radii and masses in the buffers are NaN.
int changed_by_radii_and_masses(Backend& backend, Crowd crowd);

/// An elastic gas reads no other's velocity, equal balls read no radius and no mass; where these count, they are read.
void reads_only_what_counts(Backend& backend);

}  // namespace ballpit::test
