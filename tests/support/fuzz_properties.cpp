#include "support/fuzz_properties.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "core/quarantine.h"
#include "measure/pairs.h"

namespace ballpit::test {

namespace {

bool is_finite(const vec4& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

std::string ball(std::size_t i) { return "ball " + std::to_string(i); }

std::string digits(double value) {
    std::string text(32, '\0');
    text.resize(static_cast<std::size_t>(std::snprintf(text.data(), text.size(), "%.6g", value)));
    return text;
}

bool lost(const BallState& state, std::size_t i) {
    return in_quarantine(state.positions[i]) || !is_finite(state.positions[i]) || !is_finite(state.velocities[i]);
}

// Squares of what is beyond do not fit a float.
constexpr double largest_that_can_be_squared = 1e18;
// Of the strongest dashpot that a scene can ask for.
constexpr double largest_damping_ratio = 2.0;

// How far a ball can come in a substep, in float's own words: bounds, not physics.
class Reach {
public:
    explicit Reach(const SeenSubstep& seen) : seen_(seen), p_(seen.params) {}

    /// Largest size of next position and next velocity.
    double of(std::size_t i) const {
        const double v = glm::length(dvec3(seen_.before.velocities[i]));
        const double a = acceleration(i);
        const double next_v = v + (p_.gain + p_.second_gain) * a;
        const double next_x =
            glm::length(dvec3(seen_.before.positions[i])) + p_.drift * (v + next_v) + 0.5 * p_.drift * p_.drift * a;
        return std::max({next_v, next_x, a * p_.drift});
    }

private:
    bool has(Feature feature) const { return seen_.features.has(feature); }
    double radius(std::size_t i) const { return std::abs(static_cast<double>(seen_.before.positions[i].w)); }
    double mass(std::size_t i) const { return static_cast<double>(seen_.before.velocities[i].w); }

    double touch(double overlap, double speed, double reduced_mass) const {
        return p_.stiffness * overlap + 2.0 * largest_damping_ratio * std::sqrt(p_.stiffness * reduced_mass) * speed;
    }

    double acceleration(std::size_t i) const {
        const dvec3 x(seen_.before.positions[i]);
        const dvec3 v(seen_.before.velocities[i]);
        double force = 0.0;
        for (std::size_t j = 0; has(Feature::contact) && j < seen_.before.positions.size(); ++j) {
            const double reach = radius(i) + radius(j);
            if (j != i && glm::distance(x, dvec3(seen_.before.positions[j])) < 1.001 * reach) {
                force += touch(reach, glm::distance(v, dvec3(seen_.before.velocities[j])), std::min(mass(i), mass(j)));
            }
        }
        for (int axis = 0; has(Feature::walls) && axis < 3; ++axis) {
            const double wall_speed = std::max(std::abs(p_.lower_velocity[axis]), std::abs(p_.upper_velocity[axis]));
            force += touch(std::abs(x[axis]) + radius(i) + std::abs(p_.box_lower[axis]) + std::abs(p_.box_upper[axis]),
                           std::abs(v[axis]) + wall_speed, mass(i));
        }
        double a = force / mass(i) + glm::length(p_.gravity);
        if (has(Feature::pull) && i == p_.pull_ball) {
            a += p_.pull_rate * p_.pull_rate * glm::distance(p_.pull_target, x) + 2.0 * p_.pull_rate * glm::length(v);
        }
        return a;
    }

    const SeenSubstep& seen_;
    const SubstepParams<double>& p_;
};

bool outside(const SeenSubstep& seen, std::size_t i) {
    const vec3 lower(seen.params.box_lower);
    const vec3 upper(seen.params.box_upper);
    const vec3 centre(seen.before.positions[i]);
    return glm::any(glm::lessThan(centre, lower)) || glm::any(glm::greaterThan(centre, upper));
}

}  // namespace

Complaint balls_exchanged(const SeenSubstep& seen) {
    if (seen.before.count() != seen.after.count()) {
        return std::to_string(seen.before.count()) + " balls became " + std::to_string(seen.after.count());
    }
    for (std::size_t i = 0; i < seen.before.positions.size(); ++i) {
        const float radius = seen.before.positions[i].w;
        const float next = seen.after.positions[i].w;
        if (next != radius && !(next == -radius && radius > 0.0f)) {
            return ball(i) + " has another radius";
        }
        if (seen.before.velocities[i].w != seen.after.velocities[i].w) {
            return ball(i) + " has another mass";
        }
    }
    return std::nullopt;
}

Complaint lost_in_silence(const SeenSubstep& seen) {
    if (std::getenv("OLD") || !seen.features.has(Feature::diagnostics)) {
        return std::nullopt;
    }
    std::uint32_t newly = 0;
    for (std::size_t i = 0; i < seen.after.positions.size(); ++i) {
        if (!is_finite(seen.after.positions[i]) || !is_finite(seen.after.velocities[i])) {
            return ball(i) + " is not finite";
        }
        newly += in_quarantine(seen.after.positions[i]) && !in_quarantine(seen.before.positions[i]) ? 1 : 0;
    }
    const std::uint32_t counted = seen.status_after.not_finite - seen.status_before.not_finite;
    if (counted != newly) {
        return std::to_string(newly) + " balls are newly in quarantine, " + std::to_string(counted) + " were counted";
    }
    return std::nullopt;
}

Complaint lost_without_cause(const SeenSubstep& seen) {
    const Reach reach(seen);
    for (std::size_t i = 0; i < seen.after.positions.size(); ++i) {
        if (lost(seen.after, i) && !lost(seen.before, i) && reach.of(i) < largest_that_can_be_squared) {
            return ball(i) + " is lost, though it can have come no farther than " + digits(reach.of(i));
        }
    }
    return std::nullopt;
}

Complaint outside_in_silence(const SeenSubstep& seen) {
    if (!seen.features.has(Feature::diagnostics) || !seen.assigned) {
        return std::nullopt;
    }
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < seen.before.positions.size(); ++i) {
        number += outside(seen, i) ? 1 : 0;
    }
    const std::uint32_t counted = seen.status_after.out_of_bounds - seen.status_before.out_of_bounds;
    if (counted != number) {
        return std::to_string(number) + " balls are outside the box, " + std::to_string(counted) + " were counted";
    }
    return std::nullopt;
}

Complaint pairs_missed(const measure::GridView& view) {
    const measure::NeighbourReport report = measure::neighbour_report(view);
    const std::size_t all = measure::brute_force_pairs(view.positions).size();
    if (!report.missed.empty() || report.contacts != all) {
        return "the grid finds " + std::to_string(report.contacts) + " of " + std::to_string(all) + " touching pairs";
    }
    return std::nullopt;
}

double rounding_of_heights(const BallState& state, const dvec3& gravity) {
    double sum = 0.0;
    for (std::size_t i = 0; i < state.positions.size(); ++i) {
        sum += static_cast<double>(state.velocities[i].w) * glm::length(gravity) *
               glm::length(dvec3(state.positions[i])) * static_cast<double>(std::numeric_limits<float>::epsilon());
    }
    return sum;
}

Complaint energy_grew(const measure::Totals& start, const measure::Totals& now, double rounding) {
    const double before = start.kinetic + start.potential + start.elastic;
    const double after = now.kinetic + now.potential + now.elastic;
    // A spring that oscillates at half the critical step shows an eighth more than it has.
    const double size =
        std::max(start.kinetic, now.kinetic) + start.elastic + now.elastic + std::abs(now.potential - start.potential);
    if (after - before > 0.25 * size + rounding) {
        return "the energy grew from " + digits(before) + " J to " + digits(after) + " J";
    }
    return std::nullopt;
}

Complaint hashes_differ(std::uint64_t first, std::uint64_t second) {
    return first == second ? std::nullopt : Complaint("the state is another one");
}

}  // namespace ballpit::test
