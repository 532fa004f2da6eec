// The state of the balls, in the layout of the buffers.
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "core/hash.h"
#include "core/layout.h"
#include "core/vector.h"

namespace ballpit {

struct BallState {
    std::vector<vec4> positions;       // centre (m), radius (m)
    std::vector<vec4> velocities;      // velocity (m/s), mass (kg)
    std::vector<double> restitutions;  // one a ball where some ball has its own, else empty
    double velocity_lag = 0.0;         // s by which velocities stand behind positions (integrator.h)
    /// What rounding left out of positions and velocities: one a ball, or empty where nobody keeps it.
    std::vector<Compensation> compensations{};

    std::uint32_t count() const { return static_cast<std::uint32_t>(positions.size()); }
};

/// Ball i has the places 8 i to 8 i + 7: x, y, z, radius, vx, vy, vz, mass.
inline std::uint64_t hash_state(std::span<const vec4> positions, std::span<const vec4> velocities) {
    HashSum sum;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        for (int c = 0; c < 4; ++c) {
            const auto place = static_cast<std::uint32_t>(8 * i + static_cast<std::size_t>(c));
            sum.add(std::bit_cast<std::uint32_t>(positions[i][c]), place);
            sum.add(std::bit_cast<std::uint32_t>(velocities[i][c]), place + 4);
        }
    }
    return sum.value();
}

inline std::uint64_t hash_state(const BallState& state) { return hash_state(state.positions, state.velocities); }

}  // namespace ballpit
