// Constants of one substep, in double, and their two narrower forms: the mirror's and the shader's.
#pragma once

#include "core/grid.h"
#include "core/integrator.h"
#include "core/layout.h"
#include "core/settings.h"
#include "core/vector.h"

namespace ballpit {

/// Same members as layout::SubstepParams, which says what each means.
template <class Real>
struct SubstepParams {
    Vec3<Real> gravity{0};
    Real drift{0};
    Vec3<Real> half_extent{0};
    Real inverse_cell_width{1};
    Vec3<Real> grid_origin{0};
    Real stiffness{0};
    uvec3 grid_cells{1};
    std::uint32_t ball_count = 0;
    Real decay{1};
    Real gain{0};
    Real second_decay{1};
    Real second_gain{0};
    Real damping_ratio{0};
    std::uint32_t key_count = 0;
    std::uint32_t cell_count = 1;
};

SubstepParams<double> make_substep_params(const Settings& settings, const dvec3& half_extent, const Grid& grid,
                                          const SubstepMotion& motion, std::uint32_t ball_count);

/// Rounds each member once, so that mirror and GPU start from the same numbers.
template <class Real>
SubstepParams<Real> narrowed(const SubstepParams<double>& p) {
    return {Vec3<Real>(p.gravity),
            static_cast<Real>(p.drift),
            Vec3<Real>(p.half_extent),
            static_cast<Real>(p.inverse_cell_width),
            Vec3<Real>(p.grid_origin),
            static_cast<Real>(p.stiffness),
            p.grid_cells,
            p.ball_count,
            static_cast<Real>(p.decay),
            static_cast<Real>(p.gain),
            static_cast<Real>(p.second_decay),
            static_cast<Real>(p.second_gain),
            static_cast<Real>(p.damping_ratio),
            p.key_count,
            p.cell_count};
}

layout::SubstepParams shader_params(const SubstepParams<double>& params);

}  // namespace ballpit
