#include "measure/warnings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/contact.h"
#include "core/quarantine.h"
#include "measure/energy.h"
#include "measure/pairs.h"
#include "measure/stability.h"

namespace ballpit::measure {

namespace {

// The two lightest balls, or one and a wall: the stiffest contact that there can be.
struct Stiffest {
    double mass;   // kg, m_eff
    double omega;  // 1/s
    double zeta;
};

Stiffest stiffest_contact(const Simulation& simulation) {
    const Settings& settings = simulation.settings();
    const double mass = simulation.variety().lightest_mass * (settings.laws.contact ? 0.5 : 1.0);
    const double restitution = settings.laws.restitution ? settings.restitution : 1.0;
    return {mass, std::sqrt(settings.stiffness / mass),
            damping_ratio_from_restitution(restitution, settings.limit_force)};
}

void warn(ExtremeNumbers& numbers, Extreme extreme, double value, bool passed) {
    if (passed) {
        numbers[extreme] = value;
    }
}

// An explicit dashpot's own limit: h < 2 (sqrt(1 + z^2) - z). Of a semi-implicit one the step has what is left of c.
void warn_of_step(ExtremeNumbers& numbers, const Simulation& simulation, const MeterRecord* record, double dt) {
    const Settings& settings = simulation.settings();
    const Stiffest contact = stiffest_contact(simulation);
    if (!(contact.omega > 0.0) || !(dt > 0.0)) {
        return;
    }
    const bool explicit_dashpot = !simulation.features().has(Feature::semi_implicit);
    const double h = contact.omega * dt;
    const double explicit_limit = std::sqrt(1.0 + contact.zeta * contact.zeta) - contact.zeta;
    const double of_explicit = 0.5 * h / explicit_limit;
    warn(numbers, Extreme::explicit_dashpot_limit, of_explicit,
         explicit_dashpot && contact.zeta > 0.0 && of_explicit >= 1.0);
    const double zeta =
        explicit_dashpot ? contact.zeta : contact.zeta / (1.0 + 2.0 * semi_implicit_share * contact.zeta * h);
    const double share = record != nullptr && record->reading.mass > 0.0
                             ? dt_over_critical(*record, settings)
                             : 0.5 * h / (std::sqrt(1.0 + zeta * zeta) - zeta);
    warn(numbers, Extreme::unstable_dt, share, share >= 1.0);
    const double substeps = std::numbers::pi / h;
    warn(numbers, Extreme::few_substeps_per_contact, substeps, substeps < 4.0);
    const bool historical = settings.integrator == Integrator::historical;
    if (historical || settings.integrator == Integrator::forward_euler) {
        const double c = 2.0 * contact.zeta * contact.omega * contact.mass;
        const double pushed = settings.stiffness * dt * (historical ? 0.5 : 1.0) - c;
        warn(numbers, Extreme::numerical_heating, pushed, pushed > 0.0);
    }
}

void warn_of_floats(ExtremeNumbers& numbers, const Simulation& simulation, const MeterRecord* record, double dt) {
    const Settings& settings = simulation.settings();
    const Variety& variety = simulation.variety();
    const dvec3 half = simulation.half_extent();
    const auto farthest = static_cast<float>(std::max({half.x, half.y, half.z}));
    const auto ulp = static_cast<double>(std::nextafter(farthest, std::numeric_limits<float>::infinity()) - farthest);
    const double g = settings.laws.gravity ? glm::length(settings.gravity) : 0.0;
    const bool touching = settings.laws.contact || settings.laws.walls;
    const double load = variety.lightest_mass * g;
    if (touching && load > 0.0) {
        const double share = ulp * settings.stiffness / load;
        warn(numbers, Extreme::float_floor, share, share > 0.01);
    }
    double speed = std::sqrt(4.0 * g * variety.largest_radius);
    if (record != nullptr && record->reading.mass > 0.0) {
        speed = std::max(speed, std::sqrt(2.0 * record->reading.kinetic / record->reading.mass));
    }
    const double hardly = 1e-3 * variety.largest_radius;  // m/s: at rest, for all that anybody sees
    if (speed > hardly && dt > 0.0) {
        const double share = 0.5 * ulp / (dt * speed);
        warn(numbers, Extreme::tiny_dt, share, share > 0.01);
    }
}

}  // namespace

ExtremeNumbers warnings_of(const Simulation& simulation, const MeterRecord* record) {
    ExtremeNumbers numbers;
    const Settings& settings = simulation.settings();
    const Variety& variety = simulation.variety();
    if (!(variety.total_mass > 0.0)) {
        return numbers;
    }
    const double dt = settings.dt / settings.substeps;
    if (settings.laws.contact || settings.laws.walls) {
        warn_of_step(numbers, simulation, record, dt);
    }
    if (!settings.laws.compensated) {
        warn_of_floats(numbers, simulation, record, dt);
    }
    const double diameter = 2.0 * variety.largest_radius;
    if (settings.laws.walls) {
        const dvec3 size = simulation.box().size();
        const double share = diameter / std::min({size.x, size.y, size.z});
        warn(numbers, Extreme::ball_larger_than_box, share, share > 1.0);
    }
    if (settings.laws.contact && settings.neighbours == NeighbourSearch::grid) {
        const double share = simulation.schedule().grid.cell_width / diameter;
        warn(numbers, Extreme::cell_too_small, share, share < 1.0);
    }
    return numbers;
}

ExtremeNumbers worse_of(const ExtremeNumbers& a, const ExtremeNumbers& b) {
    ExtremeNumbers worse;
    for (const ExtremeInfo& info : extreme_table()) {
        const double x = a[info.extreme];
        const double y = b[info.extreme];
        const bool fewer_is_worse =
            info.extreme == Extreme::few_substeps_per_contact || info.extreme == Extreme::cell_too_small;
        worse[info.extreme] = fewer_is_worse && x > 0.0 && y > 0.0 ? std::min(x, y) : std::max(x, y);
    }
    return worse;
}

double stored_in_overlaps(const BallState& state, const Settings& settings, Features features, const Box& box) {
    constexpr double deep = 0.1;
    bool any = false;
    if (features.has(Feature::contact)) {
        for (const Pair& pair : touching_pairs(state.positions)) {
            const vec4& a = state.positions[pair.a];
            const vec4& b = state.positions[pair.b];
            const double reach = static_cast<double>(a.w) + static_cast<double>(b.w);
            any |= reach - glm::distance(dvec3(a), dvec3(b)) > deep * reach;
        }
    }
    for (const vec4& ball : state.positions) {
        if (features.has(Feature::walls) && !in_quarantine(ball)) {
            const dvec3 gap = glm::min(dvec3(ball) - box.lower, box.upper - dvec3(ball));
            const auto radius = static_cast<double>(ball.w);
            any |= radius - std::min({gap.x, gap.y, gap.z}) > deep * 2.0 * radius;
        }
    }
    return any ? totals_of(state, settings, features, box).elastic : 0.0;
}

}  // namespace ballpit::measure
