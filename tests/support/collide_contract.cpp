// The part of the stage contract that is about collide.
#include <cmath>

#include "core/layout.h"
#include "support/brute_force.h"
#include "support/catch.h"
#include "support/stage_contract.h"
#include "support/substep_setup.h"

namespace ballpit::test {

namespace {

Features all_laws(Integrator integrator) {
    Features features = contact_features();
    for (const Feature law :
         {Feature::gravity, Feature::drag, Feature::dashpot, Feature::limit_force, Feature::walls}) {
        features.add(law);
    }
    features.add(Feature::velocity_verlet, integrator == Integrator::velocity_verlet);
    features.add(Feature::forward_euler, integrator == Integrator::forward_euler);
    features.add(Feature::historical, integrator == Integrator::historical);
    return features;
}

// Compares with brute force. Rounding enters through the overlap (a few ulp of a coordinate, times k) and once an
// operation; 1e-6 is eight roundings.
void compare_with_brute_force(Backend& backend, const BallState& state, Features features, const Settings& settings) {
    const SubstepSetup setup = setup_for(state, features, SortMethod::bitonic_fused, settings);
    run_all(backend, state, setup);
    const double dt = settings.dt / settings.substeps;
    const auto expected = brute_force_substep(state, features, settings, dvec3(box_half_extent), dt);
    const auto positions = read_slot<vec4>(backend, Slot::next_positions);
    const auto velocities = read_slot<vec4>(backend, Slot::next_velocities);
    REQUIRE(positions.size() == state.count());
    for (std::size_t i = 0; i < state.count(); ++i) {
        const auto mass = static_cast<double>(state.velocities[i].w);
        const double force_error = 1e-6 * (expected[i].contacts * settings.stiffness + 10.0 * expected[i].force_scale);
        const double velocity_error =
            dt * (force_error / mass + 1e-4) + 1e-6 * (1.0 + glm::length(expected[i].velocity));
        CAPTURE(i, expected[i].contacts);
        if (expected[i].coincident) {
            continue;
        }
        REQUIRE(glm::distance(dvec3(velocities[i]), expected[i].velocity) <= velocity_error);
        REQUIRE(glm::distance(dvec3(positions[i]), expected[i].position) <= dt * velocity_error + 2e-6);
        REQUIRE(positions[i].w == state.positions[i].w);
        REQUIRE(velocities[i].w == state.velocities[i].w);
    }
}

}  // namespace

void collides_like_brute_force(Backend& backend, std::span<const std::uint32_t> counts) {
    for (const std::uint32_t count : counts) {
        for (const Placement placement : placements) {
            for (std::size_t i = 0; i < integrator_names.size(); ++i) {
                Settings settings;
                settings.integrator = static_cast<Integrator>(i);
                settings.restitution = 0.6;
                settings.drag = 3.0;
                BallState state = placed_balls(placement, count);
                CAPTURE(count, placement_names[static_cast<std::size_t>(placement)], integrator_names[i]);
                Features features = all_laws(settings.integrator);
                compare_with_brute_force(backend, state, features, settings);
                features.add(Feature::ball_restitution);
                for (std::uint32_t ball = 0; ball < count; ++ball) {
                    state.restitutions.push_back(static_cast<double>(random_between(0.1f, 1.0f, 9, ball)));
                }
                compare_with_brute_force(backend, state, features, settings);
            }
        }
    }
}

void keeps_its_input(Backend& backend) {
    const BallState state = placed_balls(Placement::one_cell, 300);
    const SubstepSetup setup = setup_for(state, all_laws(Integrator::leapfrog), SortMethod::bitonic_fused);
    run_all(backend, state, setup);
    CHECK((read_slot<vec4>(backend, Slot::positions) == state.positions));
    CHECK((read_slot<vec4>(backend, Slot::velocities) == state.velocities));
    const auto next = read_slot<vec4>(backend, Slot::next_velocities);
    CHECK_FALSE((next == state.velocities));
    backend.swap_states();
    CHECK((read_slot<vec4>(backend, Slot::velocities) == next));
}

void parts_coincident_balls(Backend& backend) {
    for (const std::uint32_t count : {2u, 3u, 4u, 64u, 65u}) {
        BallState state;
        state.positions.assign(count, vec4(0.3f, -0.7f, 1.1f, usual_radius));
        state.velocities.assign(count, vec4(0, 0, 0, 1));
        const SubstepSetup setup = setup_for(state, contact_features(), SortMethod::bitonic_fused);
        run_all(backend, state, setup);
        vec3 sum(0.0f);
        for (const vec4& velocity : read_slot<vec4>(backend, Slot::next_velocities)) {
            sum += vec3(velocity);
        }
        CAPTURE(count);
        CHECK(glm::length(sum) <= 1e-6f * static_cast<float>(count * count));
        CHECK(status_of(backend).not_finite == 0);
        const auto next = read_slot<vec4>(backend, Slot::next_positions);
        CHECK_FALSE(next.front() == next.back());
    }
}

void contains_a_ball_that_is_no_number(Backend& backend) {
    BallState state = placed_balls(Placement::one_cell, 100);
    state.positions[17].y = std::numeric_limits<float>::quiet_NaN();
    state.velocities[40].x = std::numeric_limits<float>::infinity();
    Features features = contact_features();
    const SubstepSetup setup = setup_for(state, features, SortMethod::bitonic_fused);
    run_all(backend, state, setup);
    const Status status = status_of(backend);
    CHECK((status.bits & STATUS_NOT_FINITE) != 0);
    CHECK(status.not_finite == 2);
    const auto next = read_slot<vec4>(backend, Slot::next_positions);
    CHECK(status.quarantined_ball == 41);
    CHECK(next[17] ==
          vec4(state.positions[17].x, setup.params.box_lower.y, state.positions[17].z, -state.positions[17].w));
    CHECK(next[40] == vec4(vec3(state.positions[40]), -state.positions[40].w));
    CHECK(vec3(read_slot<vec4>(backend, Slot::next_velocities)[40]) == vec3(0.0f));
    CHECK(std::isfinite(next[18].x + next[18].y + next[18].z));
}

}  // namespace ballpit::test
