#include "core/features.h"

namespace ballpit {

Features features_of(const Settings& settings, const Variety& variety, bool walls_move) {
    const Laws& laws = settings.laws;
    const bool touching = laws.contact || laws.walls;
    const bool own = touching && (laws.ball_restitution || variety.restitutions);
    const bool dashpot = own || (touching && laws.restitution);
    Features features;
    features.add(Feature::gravity, laws.gravity);
    features.add(Feature::drag, laws.drag);
    features.add(Feature::contact, laws.contact);
    features.add(Feature::dashpot, dashpot);
    features.add(Feature::limit_force, dashpot && settings.limit_force);
    features.add(Feature::walls, laws.walls);
    features.add(Feature::ball_restitution, own);
    features.add(Feature::velocity_verlet, settings.integrator == Integrator::velocity_verlet);
    features.add(Feature::forward_euler, settings.integrator == Integrator::forward_euler);
    features.add(Feature::historical, settings.integrator == Integrator::historical);
    features.add(Feature::brute_force, laws.contact && settings.neighbours == NeighbourSearch::brute_force);
    features.add(Feature::sorted_copies,
                 laws.contact && settings.sorted_copies && settings.neighbours == NeighbourSearch::grid);
    features.add(Feature::kept_order, features.has(Feature::sorted_copies) && settings.keep_order);
    features.add(Feature::unequal_radii, touching && (laws.unequal_radii || variety.radii));
    features.add(Feature::unequal_masses, touching && (laws.unequal_masses || variety.masses));
    features.add(Feature::moving_walls, laws.walls && walls_move && dashpot);
    features.add(Feature::pull, settings.pull && settings.pull->ball < settings.balls);
    features.add(Feature::diagnostics, laws.diagnostics);
    features.add(Feature::compensated, laws.compensated);
    features.add(Feature::semi_implicit, dashpot && settings.dashpot == DashpotMethod::semi_implicit);
    return features;
}

}  // namespace ballpit
