// The state of the balls, in the layout of the buffers.
#pragma once

#include <cstdint>
#include <vector>

#include "core/hash.h"
#include "core/vector.h"

namespace ballpit {

struct BallState {
    std::vector<vec4> positions;         // centre (m), radius (m)
    std::vector<vec4> velocities;        // velocity (m/s), mass (kg)
    std::vector<float> restitutions;     // one a ball where some ball has its own, else empty
    double velocity_lag = 0.0;           // s by which velocities stand behind positions (integrator.h)

    std::uint32_t count() const { return static_cast<std::uint32_t>(positions.size()); }
};

inline std::uint64_t hash_state(const BallState& state) {
    const std::uint64_t hash = hash_bytes(std::as_bytes(std::span(state.positions)));
    return hash_bytes(std::as_bytes(std::span(state.velocities)), hash);
}

}  // namespace ballpit
