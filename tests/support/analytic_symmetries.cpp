// A26: what physics does not distinguish must not differ.
#include <algorithm>
#include <cmath>
#include <functional>

#include "support/analytic_scene.h"
#include "support/catch.h"

namespace ballpit::test {

namespace {

// The balls of a gas as a list: unequal, damped, pulled down.
Scene mixed_scene(const Machine& machine) {
    Scene scene = gas_scene(Integrator::leapfrog, 2e-4, 80);
    Simulation simulation = start(machine, scene);
    const BallState state = simulation.raw_state();
    scene.fill.reset();
    for (std::uint32_t i = 0; i < state.count(); ++i) {
        BallSpec spec = ball(dvec3(state.positions[i]), dvec3(state.velocities[i]),
                             static_cast<double>(state.positions[i].w) * (i % 3 == 0 ? 1.0 : 0.75), i % 2 == 0 ? 1 : 2);
        spec.restitution = i % 5 == 0 ? 0.5 : 0.9;
        scene.balls.push_back(spec);
    }
    scene.settings.gravity = {0.5, -0.25, -9.8};
    scene.settings.drag = 0.5;
    scene.settings.restitution = 0.8;
    scene.settings.laws.gravity = scene.settings.laws.drag = scene.settings.laws.restitution = true;
    return scene;
}

Scene mapped(Scene scene, const std::function<dvec3(const dvec3&)>& map) {
    for (BallSpec& spec : scene.balls) {
        spec.position = map(spec.position);
        spec.velocity = map(spec.velocity);
    }
    scene.settings.gravity = map(scene.settings.gravity);
    return scene;
}

// Two contacts add up to the same bits in any order, three need not.
int most_contacts(const Scene& scene, const std::vector<dvec3>& x) {
    int most = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        int contacts = 0;
        for (std::size_t j = 0; j < x.size(); ++j) {
            const double reach = scene.balls[i].radius + scene.balls[j].radius;
            contacts += i != j && glm::length(x[i] - x[j]) < reach ? 1 : 0;
        }
        most = std::max(most, contacts);
    }
    return most;
}

constexpr int symmetry_substeps = 200;

Motion mixed_motion(const Machine& machine, const Scene& scene) {
    Simulation simulation = start(machine, scene);
    int most = 0;
    for (int i = 0; i < symmetry_substeps; i += 5) {
        run(simulation, 5);
        most = std::max(most, most_contacts(scene, positions_of(simulation)));
    }
    REQUIRE(most >= 1);
    REQUIRE(most <= 2);
    return motion_of(simulation);
}

void check_same_bits(const Motion& expected, const Motion& found, const std::function<dvec3(const dvec3&)>& map) {
    for (std::size_t i = 0; i < expected.x.size(); ++i) {
        CAPTURE(i);
        CHECK((found.x[i] == map(expected.x[i])));
        CHECK((found.v[i] == map(expected.v[i])));
    }
}

double largest_distance(const std::vector<dvec3>& a, const std::vector<dvec3>& b, const dvec3& shift) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        largest = std::max(largest, glm::length(b[i] - a[i] - shift));
    }
    return largest;
}

// The mixed gas in free space, at places that survive a shift by 8 m without rounding.
Scene free_scene(const Machine& machine) {
    Scene scene = mixed_scene(machine);
    for (BallSpec& spec : scene.balls) {
        spec.position = glm::floor(spec.position * 524288.0) / 524288.0;
        spec.velocity = glm::floor(spec.velocity * 4096.0) / 4096.0;
    }
    scene.half_extent = dvec3(16.0);
    scene.settings.laws.walls = scene.settings.laws.gravity = scene.settings.laws.drag = false;
    return scene;
}

}  // namespace

void a26_mirror_rotation_permutation(const Machine& machine) {
    const Scene scene = mixed_scene(machine);
    const Motion plain = mixed_motion(machine, scene);
    for (const int axis : {0, 1, 2}) {
        const auto mirror = [axis](const dvec3& p) {
            dvec3 image = p;
            image[axis] = -image[axis];
            return image;
        };
        CAPTURE(axis);
        check_same_bits(plain, mixed_motion(machine, mapped(scene, mirror)), mirror);
    }
    // About z: the sum x^2 + y^2 + z^2 is then made of the same parts in the same order.
    const auto quarter = [](const dvec3& p) { return dvec3(-p.y, p.x, p.z); };
    check_same_bits(plain, mixed_motion(machine, mapped(scene, quarter)), quarter);

    Scene backwards = scene;
    std::ranges::reverse(backwards.balls);
    Motion found = mixed_motion(machine, backwards);
    std::ranges::reverse(found.x);
    std::ranges::reverse(found.v);
    check_same_bits(plain, found, [](const dvec3& p) { return p; });
}

void a26_translation_and_boost(const Machine& machine) {
    const Scene scene = free_scene(machine);
    const dvec3 shift(8.0, -8.0, 8.0);
    Scene shifted = scene;
    for (BallSpec& spec : shifted.balls) {
        spec.position += shift;
    }
    const auto after = [&](const Scene& which, int substeps) {
        return motion_after(machine, which, substeps * which.settings.dt);
    };
    // One substep: offsets between balls are the same floats, so velocities are the same bits.
    const Motion here = after(scene, 1);
    const Motion there = after(shifted, 1);
    constexpr double ulp = 9.5367431640625e-7;  // of a float from 8 to 16
    for (std::size_t i = 0; i < here.x.size(); ++i) {
        CHECK((here.v[i] == there.v[i]));
        for (int axis = 0; axis < 3; ++axis) {
            CHECK(std::abs(there.x[i][axis] - here.x[i][axis] - shift[axis]) <= machine.tolerance(1e-14, ulp));
        }
    }
    const Motion later = after(scene, 200);
    CHECK(largest_distance(later.x, after(shifted, 200).x, shift) <= machine.tolerance(1e-11, 200 * ulp));

    const dvec3 boost(1.0, 0.5, -0.25);
    Scene boosted = scene;
    for (BallSpec& spec : boosted.balls) {
        spec.velocity += boost;
    }
    const Motion moving = after(boosted, 200);
    CHECK(largest_distance(later.x, moving.x, 200 * scene.settings.dt * boost) <= machine.tolerance(1e-11, 1e-5));
    CHECK(largest_distance(here.x, later.x, dvec3(0.0)) > 0.01);  // something did happen
}

}  // namespace ballpit::test
