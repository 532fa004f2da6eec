// Constants of one substep, in double, and rounded to single for the mirror and the shaders. Shaders ask for them by
// the names of the members.
#pragma once

#include <algorithm>
#include <limits>
#include <span>
#include <string_view>
#include <variant>

#include "core/box.h"
#include "core/features.h"
#include "core/grid.h"
#include "core/integrator.h"
#include "core/layout.h"
#include "core/settings.h"
#include "core/vector.h"

namespace ballpit {

/// A kick turns v into decay * v + gain * a.
template <class Real>
struct SubstepParams {
    std::uint32_t ball_count = 0;
    Real drift{0};  // s: x moves by drift * v
    Real gain{0};   // s: duration of the kick, shortened by drag
    Real second_gain{0};
    Real decay{1};  // exp(-drag * duration)
    Real second_decay{1};
    Real decay_change{0};  // decay - 1
    Real second_decay_change{0};
    Vec3<Real> gravity{0};                              // m/s^2
    Real stiffness{0};                                  // N/m
    Real radius{0};                                     // m, where all balls have the same
    Real mass{1};                                       // kg, where all balls have the same
    Real damping_ratio{0};                              // dashpot zeta of balls without a restitution of their own
    Real damping_time{0};                               // s, of a semi-implicit dashpot
    Real wall_depth{std::numeric_limits<Real>::max()};  // m: overlap with a wall beyond which it pushes no harder
    Vec3<Real> box_lower{0};
    Vec3<Real> box_upper{0};
    Vec3<Real> lower_velocity{0};  // m/s, of the lower walls
    Vec3<Real> upper_velocity{0};
    Vec3<Real> pull_target{0};
    std::uint32_t pull_ball = 0;
    Real pull_rate{0};          // 1/s
    Vec3<Real> grid_origin{0};  // m: lower corner of cell 0
    Real inverse_cell_width{1};
    uvec3 grid_cells{1};  // along x, y, z
    std::uint32_t key_count = 0;
    std::uint32_t cell_count = 1;

    friend bool operator==(const SubstepParams&, const SubstepParams&) = default;
};

SubstepParams<double> make_substep_params(const Settings& settings, const Walls& walls, const Grid& grid,
                                          const SubstepMotion& motion, std::uint32_t ball_count,
                                          const Variety& variety = {});

/// Rounds each member once, so that mirror and GPU start from the same numbers.
template <class Real>
SubstepParams<Real> narrowed(const SubstepParams<double>& p) {
    const auto real = [](double value) { return static_cast<Real>(value); };
    SubstepParams<Real> n;
    n.ball_count = p.ball_count;
    n.drift = real(p.drift);
    n.gain = real(p.gain);
    n.second_gain = real(p.second_gain);
    n.decay = real(p.decay);
    n.second_decay = real(p.second_decay);
    n.decay_change = real(p.decay_change);
    n.second_decay_change = real(p.second_decay_change);
    n.gravity = Vec3<Real>(p.gravity);
    n.stiffness = real(p.stiffness);
    n.radius = real(p.radius);
    n.mass = real(p.mass);
    n.damping_ratio = real(p.damping_ratio);
    n.damping_time = real(p.damping_time);
    n.wall_depth = real(std::min(p.wall_depth, static_cast<double>(std::numeric_limits<Real>::max())));
    n.box_lower = Vec3<Real>(p.box_lower);
    n.box_upper = Vec3<Real>(p.box_upper);
    n.lower_velocity = Vec3<Real>(p.lower_velocity);
    n.upper_velocity = Vec3<Real>(p.upper_velocity);
    n.pull_target = Vec3<Real>(p.pull_target);
    n.pull_ball = p.pull_ball;
    n.pull_rate = real(p.pull_rate);
    n.grid_origin = Vec3<Real>(p.grid_origin);
    n.inverse_cell_width = real(p.inverse_cell_width);
    n.grid_cells = p.grid_cells;
    n.key_count = p.key_count;
    n.cell_count = p.cell_count;
    return n;
}

using ShaderParams = SubstepParams<float>;
using ShaderParam =
    std::variant<float ShaderParams::*, std::uint32_t ShaderParams::*, vec3 ShaderParams::*, uvec3 ShaderParams::*>;

struct ShaderParamInfo {
    std::string_view name;  // of the member of a shader's block `params`
    ShaderParam member;
};

/// Every constant that a shader may ask for.
std::span<const ShaderParamInfo> shader_param_table();

}  // namespace ballpit
