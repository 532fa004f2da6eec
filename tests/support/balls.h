// Ball states for tests: the placements that a grid can get wrong.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>

#include "core/ball_state.h"
#include "core/random.h"

namespace ballpit::test {

inline constexpr double box_half_extent = 2.0;  // m: cells of 0.25 m then have faces at dyadic numbers
inline constexpr float usual_radius = 0.125f;   // m

enum class Placement { uniform, one_cell, on_faces, outside, radii_1_to_4 };
inline constexpr std::array placements = {Placement::uniform, Placement::one_cell, Placement::on_faces,
                                          Placement::outside, Placement::radii_1_to_4};
inline constexpr std::array<std::string_view, 5> placement_names = {"uniform", "one cell", "on faces", "outside",
                                                                    "radii 1 to 4"};

inline float random_between(float low, float high, std::uint64_t stream, std::uint64_t index) {
    return low + (high - low) * static_cast<float>(random_unit(2024, stream, index));
}

/// Coordinate of a ball along one axis. `on_faces` uses faces, and the numbers next to them on both sides.
inline float coordinate(Placement placement, std::uint64_t axis, std::uint64_t ball) {
    constexpr auto half = static_cast<float>(box_half_extent);
    const float anywhere = random_between(-half, half, axis, ball);
    switch (placement) {
        case Placement::one_cell:
            return random_between(0.01f, 0.24f, axis, ball);
        case Placement::outside:
            return 2.0f * anywhere;
        case Placement::on_faces: {
            const float face = 0.25f * std::round(anywhere * 4.0f);
            const auto side = static_cast<float>(std::floor(3.0 * random_unit(77, axis, ball)) - 1.0);
            return face == 0.0f ? side * 1e-8f : std::nextafter(face, face + side);
        }
        case Placement::uniform:
        case Placement::radii_1_to_4:
            break;
    }
    return anywhere;
}

/// `count` balls of masses 0.5 to 2 kg and speeds up to 1 m/s an axis.
inline BallState placed_balls(Placement placement, std::uint32_t count) {
    BallState state;
    for (std::uint64_t i = 0; i < count; ++i) {
        const bool small = placement == Placement::radii_1_to_4 && i % 8 != 0;
        const float radius = small ? random_between(0.25f, 0.5f, 4, i) * usual_radius : usual_radius;
        state.positions.emplace_back(coordinate(placement, 0, i), coordinate(placement, 1, i),
                                     coordinate(placement, 2, i), radius);
        state.velocities.emplace_back(random_between(-1, 1, 5, i), random_between(-1, 1, 6, i),
                                      random_between(-1, 1, 7, i), random_between(0.5f, 2.0f, 8, i));
    }
    return state;
}

}  // namespace ballpit::test
