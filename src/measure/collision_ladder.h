// How the restitution of a single collision depends on the number of substeps that it lasts.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "measure/collision_probe.h"

namespace ballpit::measure {

struct CollisionRung {
    Integrator integrator = Integrator::leapfrog;
    std::uint32_t substeps_a_contact = 0;  // whole
    ProbeGroup group;                      // two balls at the typical speed, or ball and wall where balls do not touch
    /// What this integrator is expected to give without a dashpot: exp(pi^2 / (4 Nc)) for the historical one, which
    /// feeds every spring; 1 for the others, to 2.1 / Nc^3. With a dashpot the exact value.
    double expected = 1.0;
    double rounding = 0.0;  // that float positions add to the error, as a share of the speed
};

/// A rung for each integrator and number of substeps; the scene's own contact, with the step that makes the number
/// whole, and near the origin, where rounding disturbs least. None where nothing touches anything.
std::vector<CollisionRung> collision_ladder(const ProbeQuestion& question,
                                            const std::function<std::unique_ptr<Backend>()>& device);

}  // namespace ballpit::measure
