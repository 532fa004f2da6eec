// What a scene models, as a set of bits: each bit is one #define of the shader permutation and one
// branch of the mirror. An absent law has no code in the program that runs.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/settings.h"

namespace ballpit {

enum class Feature : std::uint32_t {
    gravity = 1u << 0,
    drag = 1u << 1,
    contact = 1u << 2,      // ball-ball spring: needs the grid
    dashpot = 1u << 3,      // restitution below 1: reads the neighbours' velocities
    limit_force = 1u << 4,  // a contact never pulls
    walls = 1u << 5,
    ball_restitution = 1u << 6,  // some ball has a restitution of its own
    velocity_verlet = 1u << 7,   // integrators; none of these three means kick, then drift
    forward_euler = 1u << 8,
    historical = 1u << 9,
    brute_force = 1u << 10,     // neighbours: every other ball, no grid
    unequal_radii = 1u << 11,   // without it all balls have one radius, a constant
    unequal_masses = 1u << 12,  // the same for masses
    moving_walls = 1u << 13,    // the walls' velocity enters the dashpot
    pull = 1u << 14,            // a spring on one ball
    diagnostics = 1u << 15,     // stages count what goes wrong
    compensated = 1u << 16,     // what rounding leaves out of positions and velocities is kept and added later
    semi_implicit = 1u << 17,   // a dashpot that no substep is too long for
    sorted_copies = 1u << 18,   // collide reads the state in the order of the sorted keys
    small_tiles = 1u << 19,     // of the fused sort alone
    kept_order = 1u << 20,      // balls stay in the order of their cells from substep to substep
};

inline constexpr std::array<std::string_view, 21> feature_defines = {"LAW_GRAVITY",
                                                                     "LAW_DRAG",
                                                                     "LAW_CONTACT",
                                                                     "LAW_DASHPOT",
                                                                     "LAW_LIMIT_FORCE",
                                                                     "LAW_WALLS",
                                                                     "LAW_BALL_RESTITUTION",
                                                                     "INTEGRATOR_VELOCITY_VERLET",
                                                                     "INTEGRATOR_FORWARD_EULER",
                                                                     "INTEGRATOR_HISTORICAL",
                                                                     "NEIGHBOURS_BRUTE_FORCE",
                                                                     "LAW_UNEQUAL_RADII",
                                                                     "LAW_UNEQUAL_MASSES",
                                                                     "LAW_MOVING_WALLS",
                                                                     "LAW_PULL",
                                                                     "DIAGNOSTICS",
                                                                     "LAW_COMPENSATED",
                                                                     "LAW_SEMI_IMPLICIT",
                                                                     "SORTED_COPIES",
                                                                     "SMALL_TILES",
                                                                     "KEPT_ORDER"};

struct Features {
    std::uint32_t bits = 0;

    constexpr bool has(Feature f) const { return (bits & static_cast<std::uint32_t>(f)) != 0; }
    constexpr Features without(Feature f) const { return {bits & ~static_cast<std::uint32_t>(f)}; }
    constexpr void add(Feature f, bool wanted = true) { bits |= wanted ? static_cast<std::uint32_t>(f) : 0u; }
    friend constexpr bool operator==(Features, Features) = default;
    friend constexpr auto operator<=>(Features, Features) = default;
};

/// In what the balls of a scene differ, and the value that they share in what they do not.
struct Variety {
    bool radii = false;
    bool masses = false;
    bool restitutions = false;    // some ball has its own
    float radius = 0.0f;          // m, of ball 0
    float mass = 1.0f;            // kg, of ball 0
    double largest_radius = 0.0;  // m
    double lightest_mass = 0.0;   // kg
    double heaviest_mass = 0.0;
    double total_mass = 0.0;
};

/// What these laws and settings ask for, with such balls. `walls_move`: see box.h.
Features features_of(const Settings& settings, const Variety& variety, bool walls_move);

}  // namespace ballpit
