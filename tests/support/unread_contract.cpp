#include "support/unread_contract.h"

#include <cstring>
#include <functional>
#include <limits>

#include "core/simulation.h"
#include "support/catch.h"
#include "support/law_scenes.h"
#include "support/substep_setup.h"

namespace ballpit::test {

namespace {

constexpr std::uint32_t balls = 400;
constexpr std::uint32_t step = 7;  // one ball in so many is looked at
constexpr float poison = std::numeric_limits<float>::quiet_NaN();

struct Result {
    vec4 position;
    vec4 velocity;
};

// One substep over this state, without the balls' shares of the sums in between.
struct Substep {
    Schedule schedule;
    SubstepParams<double> params;
    BallState state;

    std::vector<Result> run(Backend& backend, const BallState& from) const {
        backend.load(from, schedule, true);
        backend.run(schedule, params, 0, schedule.dispatches.size());
        const bool in_place = schedule.in_place;
        const auto positions = read_slot<vec4>(backend, in_place ? Slot::positions : Slot::next_positions);
        const auto velocities = read_slot<vec4>(backend, in_place ? Slot::velocities : Slot::next_velocities);
        std::vector<Result> results;
        for (std::size_t i = 0; i < positions.size(); ++i) {
            results.push_back({positions[i], velocities[i]});
        }
        return results;
    }
};

// The programs are those of the state as it is, whatever poison does to it later.
Substep substep_of(const Scene& scene) {
    World world = make_world(scene, balls, 5);
    const Variety variety = variety_of(world.balls);
    const Features features = features_of(scene.settings, variety, false);
    const Grid grid = make_grid(world.box, largest_radius(world.balls), 1.0, balls);
    const SubstepMotion motion = substep_motion(scene.settings.integrator, 0.0, 1e-3, 0.0);
    return {make_schedule(balls, grid, features, SortMethod::bitonic_fused),
            make_substep_params(scene.settings, world.box, grid, motion, balls, variety), std::move(world.balls)};
}

bool same_bits(const vec3& a, const vec3& b) { return std::memcmp(&a, &b, sizeof(vec3)) == 0; }

using Poison = std::function<void(BallState&, std::uint32_t spared)>;

// How many of the balls looked at come out otherwise when everything that `poisons` is poisoned around them.
int count_changed(Backend& backend, const Scene& scene, const Poison& poisons) {
    const Substep substep = substep_of(scene);
    const std::vector<Result> clean = substep.run(backend, substep.state);
    int changed = 0;
    int pushed = 0;
    for (std::uint32_t ball = 0; ball < balls; ball += step) {
        BallState poisoned = substep.state;
        poisons(poisoned, ball);
        const Result result = substep.run(backend, poisoned)[ball];
        const bool same = same_bits(vec3(result.position), vec3(clean[ball].position)) &&
                          same_bits(vec3(result.velocity), vec3(clean[ball].velocity));
        changed += same ? 0 : 1;
        pushed += vec3(clean[ball].velocity) != vec3(substep.state.velocities[ball]) ? 1 : 0;
    }
    REQUIRE(pushed > 10);  // contacts were met
    return changed;
}

void poison_velocities(BallState& state, std::uint32_t spared) {
    for (std::uint32_t i = 0; i < state.count(); ++i) {
        if (i != spared) {
            state.velocities[i] = vec4(poison);
        }
    }
}

void poison_radii_and_masses(BallState& state, std::uint32_t) {
    for (std::uint32_t i = 0; i < state.count(); ++i) {
        state.positions[i].w = poison;
        state.velocities[i].w = poison;
    }
}

Scene scene_of(Crowd crowd) {
    Scene scene = crowd == Crowd::elastic_gas ? elastic_gas_scene(balls)
                  : crowd == Crowd::mono_pile ? mono_pile_scene(balls)
                                              : mixed_pile_scene(balls);
    scene.fill->region = {dvec3(-0.6), dvec3(0.6)};
    scene.settings.laws.diagnostics = false;
    return scene;
}

}  // namespace

int changed_by_other_velocities(Backend& backend, Crowd crowd) {
    return count_changed(backend, scene_of(crowd), poison_velocities);
}

int changed_by_radii_and_masses(Backend& backend, Crowd crowd) {
    return count_changed(backend, scene_of(crowd), poison_radii_and_masses);
}

void reads_only_what_counts(Backend& backend) {
    CHECK(changed_by_other_velocities(backend, Crowd::elastic_gas) == 0);
    CHECK(changed_by_radii_and_masses(backend, Crowd::elastic_gas) == 0);
    CHECK(changed_by_radii_and_masses(backend, Crowd::mono_pile) == 0);
    CHECK(changed_by_other_velocities(backend, Crowd::mono_pile) > 10);
    CHECK(changed_by_radii_and_masses(backend, Crowd::mixed_pile) > 10);
}

}  // namespace ballpit::test
