#include "measure/collision_ladder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "measure/float_spacing.h"

namespace ballpit::measure {

namespace {

constexpr std::array<std::uint32_t, 9> rungs = {8, 10, 12, 16, 20, 24, 32, 48, 64};
constexpr std::array integrators = {Integrator::leapfrog, Integrator::symplectic_euler, Integrator::velocity_verlet,
                                    Integrator::historical};

double expected_restitution(Integrator integrator, double exact, std::uint32_t substeps) {
    const bool elastic = exact == 1.0;
    return elastic && integrator == Integrator::historical
               ? std::exp(std::numbers::pi * std::numbers::pi / (4.0 * substeps))
               : exact;
}

// What rounding of positions makes of a speed that is seen over one substep.
double rounding_error(const ProbeQuestion& question, double speed) {
    return float_spacing(question.scene.distance) / (speed * question.settings.dt);
}

}  // namespace

std::vector<CollisionRung> collision_ladder(const ProbeQuestion& question,
                                            const std::function<std::unique_ptr<Backend>()>& device) {
    std::vector<CollisionRung> ladder;
    const double frequency = contact_frequency(question, !question.settings.laws.contact);
    if (!(frequency > 0.0)) {
        return ladder;
    }
    const auto backend = device();
    for (const Integrator integrator : integrators) {
        for (const std::uint32_t substeps : rungs) {
            ProbeQuestion rung = question;
            // Near the origin, where float tells most apart; farther than the balls fly.
            rung.scene.distance = std::min(rung.scene.distance, 6.0 * rung.scene.radius);
            rung.settings.integrator = integrator;
            rung.settings.substeps = 1;
            rung.settings.dt = std::numbers::pi / (frequency * substeps);
            const ProbeResult result = run_probe(*backend, rung);
            if (result.groups.empty()) {
                return {};
            }
            const ProbeGroup& group = result.groups.front();
            ladder.push_back({integrator, substeps, group,
                              expected_restitution(integrator, group.restitution.exact, substeps),
                              rounding_error(rung, group.speed)});
        }
    }
    return ladder;
}

}  // namespace ballpit::measure
