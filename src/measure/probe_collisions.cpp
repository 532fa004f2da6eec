#include "measure/probe_collisions.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/contact.h"

namespace ballpit::measure {

namespace {

constexpr double lead = 1.0;      // substeps before the one in which a contact begins
constexpr double patience = 1.5;  // exact durations: errors make contacts longer
constexpr std::uint32_t after = 8;
constexpr std::uint32_t sites_in_a_row = 16;
constexpr double spacing = 4.0;  // diameters between collisions

double substep_dt(const Settings& settings) { return settings.dt / settings.substeps; }

double rounded(double value) { return static_cast<double>(static_cast<float>(value)); }

std::string reason(const ProbeQuestion& question) {
    const Settings& s = question.settings;
    if (!s.laws.contact && !s.laws.walls) {
        return "nothing touches in this scene: there is no collision to probe";
    }
    if (question.scene.radius == 0.0) {
        return "there are no balls";
    }
    if (s.stiffness == 0.0) {
        return "a contact without stiffness pushes nothing";
    }
    if (s.dt == 0.0) {
        return "a step of 0 s moves nothing";
    }
    return {};
}

// Where the 256 stand, across the direction in which they move.
dvec3 site(std::size_t i, double diameter) {
    const std::size_t line = i / sites_in_a_row;
    const auto row = static_cast<double>(line);
    const auto column = static_cast<double>(i % sites_in_a_row);
    constexpr double middle = 0.5 * (sites_in_a_row - 1.0);
    return spacing * diameter * dvec3(0.0, column - middle, row - middle);
}

struct Builder {
    const ProbeQuestion& question;
    ProbeCollisions& probe;

    double diameter() const { return 2.0 * question.scene.radius; }

    void add_ball(const dvec3& position, double velocity) {
        probe.balls.positions.emplace_back(vec3(position), static_cast<float>(question.scene.radius));
        probe.balls.velocities.emplace_back(vec3(static_cast<float>(velocity), 0.0f, 0.0f),
                                            static_cast<float>(question.scene.mass));
    }

    // Two balls as far out as the wall; nothing else is there, so that they have room to come apart.
    void add_pair(const dvec3& place, double speed, double gap) {
        const double centre = std::max(question.scene.distance - diameter(), 0.0);
        const double half = 0.5 * (diameter() + gap);
        add_ball(place + dvec3(centre - half, 0.0, 0.0), 0.5 * speed);
        add_ball(place + dvec3(centre + half, 0.0, 0.0), -0.5 * speed);
    }

    void add_group(bool wall, double speed) {
        const double dt = substep_dt(question.settings);
        for (std::uint32_t i = 0; i < probe_phases; ++i) {
            const double gap = speed * dt * (lead + (i + 0.5) / probe_phases);
            const dvec3 place = site(probe.collisions.size(), diameter());
            const std::uint32_t ball = probe.balls.count();
            if (wall) {
                add_ball(place + dvec3(probe.wall + question.scene.radius + gap, 0.0, 0.0), -speed);
            } else {
                add_pair(place, speed, gap);
            }
            const double exact_speed = wall ? rounded(speed) : 2.0 * rounded(0.5 * speed);
            const double radius = rounded(question.scene.radius);
            probe.collisions.push_back({ball, wall, exact_speed, wall ? radius : 2.0 * radius});
        }
    }
};

std::uint32_t substeps_needed(const ProbeQuestion& question, double damping_ratio) {
    const bool wall = question.settings.laws.walls;  // that contact is the longer one
    const double duration =
        contact_duration(damping_ratio, question.settings.limit_force) / contact_frequency(question, wall);
    const double substeps = std::ceil(patience * duration / substep_dt(question.settings));
    return substeps < most_probe_substeps
               ? static_cast<std::uint32_t>(lead) + 1 + static_cast<std::uint32_t>(substeps) + after
               : std::numeric_limits<std::uint32_t>::max();
}

// Around the pairs; the balls at the wall have the outermost cells beside them.
Grid probe_grid(const ProbeQuestion& question, std::uint32_t balls) {
    const double diameter = 2.0 * question.scene.radius;
    const double across = 0.5 * (sites_in_a_row + 1.0) * spacing * diameter;
    const double centre = std::max(question.scene.distance - diameter, 0.0);
    const Box box(dvec3(centre - 4.0 * diameter, -across, -across), dvec3(centre + 4.0 * diameter, across, across));
    // Cells that miss pairs on purpose are not what is measured here.
    return make_grid(box, question.scene.radius, std::max(question.settings.cell_factor, 1.0), balls);
}

}  // namespace

double contact_frequency(const ProbeQuestion& question, bool wall) {
    return std::sqrt(question.settings.stiffness / (wall ? question.scene.mass : 0.5 * question.scene.mass));
}

ProbeCollisions make_probe_collisions(const ProbeQuestion& question) {
    ProbeCollisions probe;
    probe.nothing = reason(question);
    if (!probe.nothing.empty()) {
        return probe;
    }
    const Settings& settings = question.settings;
    probe.damping_ratio = rounded(damping_ratio_from_restitution(question.scene.restitution, settings.limit_force));
    probe.substeps = substeps_needed(question, probe.damping_ratio);
    if (probe.substeps > most_probe_substeps) {
        probe.nothing = "a contact lasts more than ten thousand substeps: it is not run";
        return probe;
    }
    probe.wall = -rounded(question.scene.distance);
    Builder builder{question, probe};
    for (const bool wall : {false, true}) {
        if (wall ? settings.laws.walls : settings.laws.contact) {
            builder.add_group(wall, question.scene.typical_speed);
            builder.add_group(wall, question.scene.largest_speed);
        }
    }
    const Features features = features_of(settings, question.scene.variety, question.scene.walls_move);
    if (features.has(Feature::ball_restitution)) {
        probe.balls.restitutions.assign(probe.balls.count(), question.scene.restitution);
    }
    const std::uint32_t balls = probe.balls.count();
    probe.schedule = make_schedule(balls, probe_grid(question, balls), features, settings.sort);
    return probe;
}

SubstepParams<double> probe_params(const ProbeQuestion& question, const ProbeCollisions& collisions,
                                   double velocity_lag) {
    Settings still = question.settings;
    still.gravity = dvec3(0.0);
    still.pull.reset();
    still.restitution = question.scene.restitution;
    still.laws.restitution = true;  // 1 where there is no such law
    Variety variety = question.scene.variety;
    variety.radius = static_cast<float>(question.scene.radius);
    variety.mass = static_cast<float>(question.scene.mass);
    const double far = 1e3 * (question.scene.distance + question.scene.radius);
    const Box box(dvec3(collisions.wall, -far, -far), dvec3(far));
    const SubstepMotion motion = substep_motion(still.integrator, 0.0, substep_dt(still), velocity_lag);
    SubstepParams<double> params =
        make_substep_params(still, Walls(box), collisions.schedule.grid, motion, collisions.balls.count(), variety);
    params.pull_ball = SENTINEL;  // nobody's number
    return params;
}

}  // namespace ballpit::measure
