#include "support/gallery.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/simulation.h"
#include "measure/pairs.h"
#include "support/catch.h"
#include "support/scenes.h"

namespace ballpit::test {

namespace {

constexpr int steps = 600;

double overlap_of_pairs(const BallState& state) {
    double largest = 0.0;
    for (const measure::Pair& pair : measure::touching_pairs(state.positions)) {
        const vec4& a = state.positions[pair.a];
        const vec4& b = state.positions[pair.b];
        const double reach = static_cast<double>(a.w) + static_cast<double>(b.w);
        const double smaller = 2.0 * static_cast<double>(std::min(a.w, b.w));
        largest = std::max(largest, (reach - glm::distance(dvec3(a), dvec3(b))) / smaller);
    }
    return largest;
}

// m, of the centre of the ball beyond the wall that it is farthest outside of; negative inside.
double beyond_walls(const vec4& ball, const Box& box) {
    const dvec3 beyond = glm::max(box.lower - dvec3(ball), dvec3(ball) - box.upper);
    return std::max({beyond.x, beyond.y, beyond.z});
}

bool is_finite(const vec4& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

// What the run has come to so far, in the terms of the bounds.
struct Extremes {
    Bounds most;
    bool finite = true;

    void add(const BallState& state, const Box& box, const Laws& laws) {
        for (std::size_t i = 0; i < state.count(); ++i) {
            const vec4& ball = state.positions[i];
            const auto radius = static_cast<double>(ball.w);
            finite = finite && is_finite(ball) && is_finite(state.velocities[i]);
            most.speed = std::max(most.speed, glm::length(dvec3(state.velocities[i])));
            most.outside = std::max(most.outside, beyond_walls(ball, box));
            if (laws.walls) {
                most.overlap = std::max(most.overlap, (beyond_walls(ball, box) + radius) / (2.0 * radius));
            }
        }
        if (laws.contact) {
            most.overlap = std::max(most.overlap, overlap_of_pairs(state));
        }
    }
};

Extremes run(Simulation& simulation) {
    Extremes extremes;
    for (int step = 0; step < steps && extremes.finite; ++step) {
        simulation.step();
        extremes.add(simulation.raw_state(), simulation.box(), simulation.settings().laws);
    }
    return extremes;
}

void tell(std::string_view scene, const Bounds& most, const Bounds& bounds) {
    std::printf("%-22s speed %8.4g of %6g m/s   overlap %8.4g of %6g   outside %8.4g of %6g m\n",
                std::string(scene).c_str(), most.speed, bounds.speed, most.overlap, bounds.overlap, most.outside,
                bounds.outside);
    std::fflush(stdout);
}

}  // namespace

void gallery_keeps_its_bounds(const std::function<std::unique_ptr<Backend>()>& make_backend, std::uint32_t most_balls,
                              bool told) {
    for (const std::string_view name : shipped_scene_names) {
        const Scene scene = shipped_scene(name);
        CAPTURE(name);
        REQUIRE(scene.bounds);
        Settings settings = scene.settings;
        const auto listed = static_cast<std::uint32_t>(scene.balls.size());
        settings.balls = std::max(listed, std::min(settings.balls, most_balls));  // a chain needs all its links
        Simulation simulation(scene, settings, seed_of(scene), make_backend());
        const Extremes extremes = run(simulation);
        if (told) {
            tell(name, extremes.most, *scene.bounds);
        }
        CHECK(extremes.finite);
        CHECK(extremes.most.speed <= scene.bounds->speed);
        CHECK(extremes.most.overlap <= scene.bounds->overlap);
        CHECK(extremes.most.outside <= scene.bounds->outside);
        const auto status = read_slot<Status>(simulation.backend(), Slot::status).front();
        CHECK(status.not_finite == 0);
        CHECK(status.over_capacity == 0);
    }
}

}  // namespace ballpit::test
