#include "core/substep_params.h"

#include <algorithm>
#include <array>
#include <bit>

#include "core/contact.h"
#include "core/wall_depth.h"

namespace ballpit {

namespace {

// A hand is quick, but not so quick that a substep cannot follow the spring that stands for it.
constexpr double hand_rate = 10.0;  // 1/s
constexpr double rate_per_substep = 0.5;

constexpr std::array<ShaderParamInfo, 27> table = {{
    {"ball_count", &ShaderParams::ball_count},
    {"drift", &ShaderParams::drift},
    {"gain", &ShaderParams::gain},
    {"second_gain", &ShaderParams::second_gain},
    {"decay", &ShaderParams::decay},
    {"second_decay", &ShaderParams::second_decay},
    {"decay_change", &ShaderParams::decay_change},
    {"second_decay_change", &ShaderParams::second_decay_change},
    {"gravity", &ShaderParams::gravity},
    {"stiffness", &ShaderParams::stiffness},
    {"radius", &ShaderParams::radius},
    {"mass", &ShaderParams::mass},
    {"damping_ratio", &ShaderParams::damping_ratio},
    {"damping_time", &ShaderParams::damping_time},
    {"wall_depth", &ShaderParams::wall_depth},
    {"box_lower", &ShaderParams::box_lower},
    {"box_upper", &ShaderParams::box_upper},
    {"lower_velocity", &ShaderParams::lower_velocity},
    {"upper_velocity", &ShaderParams::upper_velocity},
    {"pull_target", &ShaderParams::pull_target},
    {"pull_ball", &ShaderParams::pull_ball},
    {"pull_rate", &ShaderParams::pull_rate},
    {"grid_origin", &ShaderParams::grid_origin},
    {"inverse_cell_width", &ShaderParams::inverse_cell_width},
    {"grid_cells", &ShaderParams::grid_cells},
    {"key_count", &ShaderParams::key_count},
    {"cell_count", &ShaderParams::cell_count},
}};

}  // namespace

SubstepParams<double> make_substep_params(const Settings& settings, const Walls& walls, const Grid& grid,
                                          const SubstepMotion& motion, std::uint32_t ball_count,
                                          const Variety& variety) {
    // Without the law a ball that has no restitution of its own bounces back as fast as it came.
    const double restitution = settings.laws.restitution ? settings.restitution : 1.0;
    SubstepParams<double> p;
    p.ball_count = ball_count;
    p.drift = motion.drift;
    p.gain = motion.first.gain;
    p.second_gain = motion.second.gain;
    p.decay = motion.first.decay;
    p.second_decay = motion.second.decay;
    p.decay_change = motion.first.decay_change;
    p.second_decay_change = motion.second.decay_change;
    p.gravity = settings.gravity;
    p.stiffness = settings.stiffness;
    p.radius = static_cast<double>(variety.radius);
    p.mass = static_cast<double>(variety.mass);
    p.damping_ratio = damping_ratio_from_restitution(restitution, settings.limit_force);
    p.damping_time = semi_implicit_share * settings.dt / settings.substeps;
    p.wall_depth = wall_depth(settings, walls.box, variety);
    p.box_lower = walls.box.lower;
    p.box_upper = walls.box.upper;
    p.lower_velocity = walls.lower_velocity;
    p.upper_velocity = walls.upper_velocity;
    if (settings.pull) {
        p.pull_target = settings.pull->target;
        p.pull_ball = settings.pull->ball;
        const double dt = settings.dt / settings.substeps;
        p.pull_rate = dt > 0.0 ? std::min(hand_rate, rate_per_substep / dt) : hand_rate;
    }
    p.grid_origin = grid.origin;
    p.inverse_cell_width = 1.0 / grid.cell_width;
    p.grid_cells = grid.cells;
    p.key_count = ball_count == 0 ? 0 : std::bit_ceil(ball_count);
    p.cell_count = grid.cell_count();
    return p;
}

std::span<const ShaderParamInfo> shader_param_table() { return table; }

}  // namespace ballpit
