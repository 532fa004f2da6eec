#include "core/substep_params.h"

#include <bit>

#include "core/contact.h"

namespace ballpit {

SubstepParams<double> make_substep_params(const Settings& settings, const dvec3& half_extent, const Grid& grid,
                                          const SubstepMotion& motion, std::uint32_t ball_count) {
    SubstepParams<double> p;
    p.gravity = settings.gravity;
    p.drift = motion.drift;
    p.half_extent = half_extent;
    p.inverse_cell_width = 1.0 / grid.cell_width;
    p.grid_origin = grid.origin;
    p.stiffness = settings.stiffness;
    p.grid_cells = grid.cells;
    p.ball_count = ball_count;
    p.decay = motion.first.decay;
    p.gain = motion.first.gain;
    p.second_decay = motion.second.decay;
    p.second_gain = motion.second.gain;
    p.damping_ratio = damping_ratio_from_restitution(settings.restitution, settings.limit_force);
    p.key_count = ball_count == 0 ? 0 : std::bit_ceil(ball_count);
    p.cell_count = grid.cell_count();
    return p;
}

layout::SubstepParams shader_params(const SubstepParams<double>& params) {
    const auto p = narrowed<float>(params);
    return {p.gravity,    p.drift, p.half_extent, p.inverse_cell_width, p.grid_origin, p.stiffness,     p.grid_cells,
            p.ball_count, p.decay, p.gain,        p.second_decay,       p.second_gain, p.damping_ratio, p.key_count,
            p.cell_count, 0u};
}

}  // namespace ballpit
