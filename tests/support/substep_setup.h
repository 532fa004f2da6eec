// Everything that one substep over a given state needs, without a scene.
#pragma once

#include <algorithm>

#include "core/backend.h"
#include "core/world.h"
#include "support/balls.h"

namespace ballpit::test {

struct SubstepSetup {
    Settings settings;
    Schedule schedule;
    SubstepParams<double> params;

    /// Dispatches [first, last) of one stage.
    std::pair<std::size_t, std::size_t> range_of(Stage stage) const {
        const auto is_stage = [stage](const Dispatch& dispatch) { return dispatch.stage == stage; };
        const auto& all = schedule.dispatches;
        const auto first = std::find_if(all.begin(), all.end(), is_stage);
        const auto last = std::find_if_not(first, all.end(), is_stage);
        return {static_cast<std::size_t>(first - all.begin()), static_cast<std::size_t>(last - all.begin())};
    }
};

inline Features contact_features() {
    Features features;
    features.add(Feature::contact);
    return features;
}

/// Sixteen cells an axis whose faces are dyadic numbers, so that a ball can lie exactly on one.
inline Grid dyadic_grid() { return {dvec3(-box_half_extent), 0.25, uvec3(16)}; }

inline SubstepSetup setup_for(const BallState& state, Features features, SortMethod sort, const Settings& settings = {},
                              const Grid& grid = dyadic_grid(), const dvec3& half_extent = dvec3(box_half_extent)) {
    const Variety variety = variety_of(state);
    features.add(Feature::unequal_radii, variety.radii);
    features.add(Feature::unequal_masses, variety.masses);
    features.add(Feature::diagnostics);
    SubstepSetup setup{settings, make_schedule(state.count(), grid, features, sort), {}};
    setup.settings.laws.restitution = features.has(Feature::dashpot);
    const double drag = features.has(Feature::drag) ? settings.drag : 0.0;
    const SubstepMotion motion = substep_motion(settings.integrator, drag, settings.dt / settings.substeps, 0.0);
    setup.params = make_substep_params(setup.settings, half_extent, grid, motion, state.count(), variety);
    return setup;
}

inline void run_stage(Backend& backend, const SubstepSetup& setup, Stage stage) {
    const auto [first, last] = setup.range_of(stage);
    backend.run(setup.schedule, setup.params, first, last);
}

inline void run_all(Backend& backend, const BallState& state, const SubstepSetup& setup) {
    backend.load(state, setup.schedule, setup.settings.limit_force);
    backend.run(setup.schedule, setup.params, 0, setup.schedule.dispatches.size());
}

inline Status status_of(Backend& backend) { return read_slot<Status>(backend, Slot::status).at(0); }

template <class T>
void write_slot(Backend& backend, Slot slot, const std::vector<T>& elements) {
    backend.write(slot, std::as_bytes(std::span(elements)));
}

}  // namespace ballpit::test
