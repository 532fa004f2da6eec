#include "measure/probe_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "measure/pairs.h"

namespace ballpit::measure {

namespace {

struct Census {
    double smallest_radius = std::numeric_limits<double>::infinity();
    double lightest = std::numeric_limits<double>::infinity();
    double radius = 0.0;          // sum
    double volume = 0.0;          // sum, m^3
    double square_speed = 0.0;    // sum of v^2 + g h
    double largest_square = 0.0;  // of v^2 + 2 g h
    double largest_now = 0.0;     // of v^2
    dvec3 lower{std::numeric_limits<double>::infinity()};
    dvec3 upper{-std::numeric_limits<double>::infinity()};
};

// m^2/s^2: g h, summed over the walls that the ball may fall to. Without walls a ball never arrives.
double fall(const dvec3& position, double radius, const Settings& settings, const Box& box) {
    if (!settings.laws.gravity || !settings.laws.walls) {
        return 0.0;
    }
    double sum = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double g = settings.gravity[axis];
        const double height =
            g < 0.0 ? position[axis] - radius - box.lower[axis] : box.upper[axis] - radius - position[axis];
        sum += std::abs(g) * std::max(height, 0.0);
    }
    return sum;
}

Census take_census(const BallState& state, const Settings& settings, const Box& box) {
    Census census;
    for (std::size_t i = 0; i < state.positions.size(); ++i) {
        const dvec3 x(state.positions[i]);
        const dvec3 v(state.velocities[i]);
        const auto radius = static_cast<double>(state.positions[i].w);
        const double square = glm::dot(v, v);
        if (!std::isfinite(square) || !std::isfinite(glm::dot(x, x))) {
            continue;  // counted elsewhere
        }
        const double falls = fall(x, radius, settings, box);
        census.smallest_radius = std::min(census.smallest_radius, radius);
        census.lightest = std::min(census.lightest, static_cast<double>(state.velocities[i].w));
        census.radius += radius;
        census.volume += 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
        census.square_speed += square + falls;
        census.largest_square = std::max(census.largest_square, square + 2.0 * falls);
        census.largest_now = std::max(census.largest_now, square);
        census.lower = glm::min(census.lower, x - radius);
        census.upper = glm::max(census.upper, x + radius);
    }
    return census;
}

// Balls that begin deep inside each other fly apart: what their springs hold becomes speed. What presses balls at rest
// into each other stays far below a tenth of a diameter.
void add_release(Census& census, const BallState& state, const Settings& settings) {
    constexpr double no_rest = 0.1;
    if (!settings.laws.contact) {
        return;
    }
    std::vector<double> square(state.positions.size());  // m^2/s^2, a ball
    for (const Pair& pair : touching_pairs(state.positions)) {
        const vec4& a = state.positions[pair.a];
        const vec4& b = state.positions[pair.b];
        const double reach = static_cast<double>(a.w) + static_cast<double>(b.w);
        const double overlap = reach - glm::distance(dvec3(a), dvec3(b));
        if (overlap > no_rest * reach) {  // each ball gets half of k d^2 / 2
            const double energy = 0.5 * settings.stiffness * overlap * overlap;
            square[pair.a] += energy / static_cast<double>(state.velocities[pair.a].w);
            square[pair.b] += energy / static_cast<double>(state.velocities[pair.b].w);
        }
    }
    for (const double each : square) {
        census.square_speed += each;
        census.largest_square = std::max(census.largest_square, each);
        census.largest_now = std::max(census.largest_now, each);
    }
}

double wall_speed(const Settings& settings, bool walls_move) {
    const double shaken =
        settings.laws.shake ? 2.0 * std::numbers::pi * settings.shake_frequency * glm::length(settings.shake_amplitude)
                            : 0.0;
    return shaken + (walls_move && !settings.laws.shake ? settings.wall_speed : 0.0);
}

void set_speeds(ProbeScene& scene, const Census& census, const Settings& settings, double balls) {
    scene.typical_speed = std::sqrt(census.square_speed / balls);
    scene.largest_speed = std::sqrt(census.largest_square);
    if (settings.laws.drag && settings.drag > 0.0) {
        const double terminal = settings.laws.gravity ? glm::length(settings.gravity) / settings.drag : 0.0;
        scene.largest_speed = std::min(scene.largest_speed, std::max(std::sqrt(census.largest_now), terminal));
        scene.typical_speed = std::min(scene.typical_speed, scene.largest_speed);
    }
    if (settings.laws.contact && scene.restitution == 1.0) {
        // Balls that lose nothing share their energy out: this is about the fastest of so many of Maxwell's.
        scene.largest_speed =
            std::max(scene.largest_speed, scene.typical_speed * std::sqrt(2.0 / 3.0 * std::log(balls)));
    }
    const double walls = wall_speed(settings, scene.walls_move);
    scene.typical_speed = std::max(scene.typical_speed, walls);
    scene.largest_speed += walls;
    if (scene.largest_speed == 0.0) {
        scene.speed_is_assumed = true;
        const double frequency = std::sqrt(2.0 * settings.stiffness / scene.mass);
        scene.typical_speed = scene.largest_speed = 0.01 * 2.0 * scene.radius * frequency;
    }
}

void set_rates(ProbeScene& scene, const Census& census, const Settings& settings, const Box& box, double balls) {
    const dvec3 size = glm::max(census.upper - census.lower, dvec3(2.0 * scene.radius));
    const double volume = size.x * size.y * size.z;
    const double share = std::min(census.volume / volume, 0.6);  // a pile is no gas: it has no more than this
    const double square = scene.typical_speed * scene.typical_speed / 3.0;  // kT / m
    if (settings.laws.contact) {
        const double diameter = 2.0 * census.radius / balls;
        const double crowding = (1.0 - 0.5 * share) / std::pow(1.0 - share, 3.0);
        scene.pair_rate =
            4.0 * (balls - 1.0) / volume * diameter * diameter * crowding * std::sqrt(std::numbers::pi * square);
    }
    if (settings.laws.walls) {
        const dvec3 b = box.size();
        const double area = 2.0 * (b.x * b.y + b.y * b.z + b.z * b.x);
        scene.wall_rate = 0.25 * std::sqrt(8.0 / std::numbers::pi * square) * area / (b.x * b.y * b.z);
    }
}

}  // namespace

ProbeScene probe_scene(const BallState& state, const Settings& settings, const Box& box, const Variety& variety,
                       bool walls_move) {
    ProbeScene scene;
    scene.variety = variety;
    scene.walls_move = walls_move;
    const dvec3 extent = box.half_extent();
    scene.distance = std::max({extent.x, extent.y, extent.z});
    Census census = take_census(state, settings, box);
    add_release(census, state, settings);
    if (census.radius == 0.0) {
        return scene;  // no balls, or none that is where it should be
    }
    scene.radius = census.smallest_radius;
    scene.mass = census.lightest;
    scene.restitution = settings.laws.restitution ? settings.restitution : 1.0;
    if (!state.restitutions.empty()) {
        scene.restitution = *std::ranges::min_element(state.restitutions);
    }
    const auto balls = static_cast<double>(state.count());
    set_speeds(scene, census, settings, balls);
    set_rates(scene, census, settings, box, balls);
    return scene;
}

}  // namespace ballpit::measure
