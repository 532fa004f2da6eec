#include "measure/energy.h"

#include <algorithm>

#include "core/quarantine.h"
#include "core/wall_depth.h"
#include "core/world.h"
#include "measure/pairs.h"

namespace ballpit::measure {

namespace {

void add_spring(Totals& totals, double overlap, double stiffness, double depth) {
    totals.elastic += capped_spring_energy(stiffness, overlap, depth);
    totals.max_overlap = std::max(totals.max_overlap, overlap);
}

void add_walls(Totals& totals, const vec4& ball, const Box& box, double stiffness, double depth) {
    for (int axis = 0; axis < 3; ++axis) {
        const auto position = static_cast<double>(ball[axis]);
        for (const double gap : {position - box.lower[axis], box.upper[axis] - position}) {
            const double overlap = static_cast<double>(ball.w) - gap;
            if (overlap > 0.0) {
                add_spring(totals, overlap, stiffness, depth);
            }
        }
    }
}

}  // namespace

Totals totals_of(const BallState& state, const Settings& settings, Features features, const Box& box) {
    Totals totals;
    const double depth = wall_depth(settings, box, variety_of(state));
    for (std::size_t i = 0; i < state.positions.size(); ++i) {
        if (in_quarantine(state.positions[i])) {
            continue;
        }
        const auto mass = static_cast<double>(state.velocities[i].w);
        const dvec3 velocity(state.velocities[i]);
        const dvec3 position(state.positions[i]);
        totals.kinetic += 0.5 * mass * glm::dot(velocity, velocity);
        totals.momentum += mass * velocity;
        if (features.has(Feature::gravity)) {
            totals.potential -= mass * glm::dot(settings.gravity, position);
        }
        if (features.has(Feature::walls)) {
            add_walls(totals, state.positions[i], box, settings.stiffness, depth);
        }
    }
    if (features.has(Feature::contact)) {
        for (const Pair& pair : touching_pairs(state.positions)) {
            const vec4& a = state.positions[pair.a];
            const vec4& b = state.positions[pair.b];
            const double reach = static_cast<double>(a.w) + static_cast<double>(b.w);
            const double overlap = std::max(0.0, reach - glm::distance(dvec3(a), dvec3(b)));
            add_spring(totals, overlap, settings.stiffness, overlap);
            ++totals.contacts;
        }
    }
    return totals;
}

}  // namespace ballpit::measure
