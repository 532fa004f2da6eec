#include "support/analytic_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cpu/cpu_backend.h"

namespace ballpit::test {

const double pair_frequency = std::sqrt(2.0 * canonical_stiffness);
const double wall_frequency = std::sqrt(canonical_stiffness);

namespace {

template <class Vector>
std::vector<dvec3> in_double(const Vector& elements) {
    std::vector<dvec3> result;
    result.reserve(elements.size());
    for (const auto& element : elements) {
        result.emplace_back(element);
    }
    return result;
}

// synchronised_state() rounds to float, which would hide what the reference knows.
std::vector<dvec3> exact_velocities(Simulation& simulation, cpu::CpuBackend<double>& reference) {
    const double lag = simulation.velocity_lag();
    if (lag == 0.0) {
        return in_double(reference.velocities());
    }
    const Settings& settings = simulation.settings();
    const double drag = settings.laws.drag ? settings.drag : 0.0;
    SubstepParams<double> kick = simulation.params();
    kick.drift = 0.0;
    kick.decay = std::exp(-drag * lag);
    kick.gain = drag == 0.0 ? lag : (1.0 - kick.decay) / drag;
    kick.second_decay = 1.0;
    kick.second_gain = 0.0;
    const Schedule& schedule = simulation.schedule();
    const auto before = reference.save();
    reference.run(schedule, kick, 0, schedule.dispatches.size());
    auto velocities = in_double(schedule.in_place ? reference.velocities() : reference.next_velocities());
    reference.restore(*before, schedule);
    return velocities;
}

void place_as_stored(BallSpec& spec, const vec4& position) {
    spec.position = dvec3(position);
    spec.radius = static_cast<double>(position.w);
}

}  // namespace

double stored(double value) { return static_cast<double>(static_cast<float>(value)); }

BallSpec ball(const dvec3& position, const dvec3& velocity, double radius, double mass) {
    return {position, velocity, radius, mass, std::nullopt};
}

Scene scene_of(std::vector<BallSpec> balls, Integrator integrator, double dt) {
    Scene scene;
    scene.name = "analytic";
    scene.half_extent = dvec3(4.0);
    scene.balls = std::move(balls);
    scene.settings.balls = static_cast<std::uint32_t>(scene.balls.size());
    scene.settings.integrator = integrator;
    scene.settings.dt = dt;
    scene.settings.substeps = 1;
    scene.settings.stiffness = canonical_stiffness;
    scene.settings.restitution = 1.0;
    return scene;
}

Scene wall_scene(std::vector<BallSpec> balls, Integrator integrator, double dt) {
    Scene scene = scene_of(std::move(balls), integrator, dt);
    scene.settings.laws.walls = true;
    return scene;
}

Scene drop_scene(Integrator integrator, double dt) {
    std::vector<BallSpec> balls;
    balls.reserve(16);
    for (int i = 0; i < 16; ++i) {
        balls.push_back(ball({0.0, 0.0, 1.1 - drop_depth + 0.01 * (i - 7.5) / 8.0}, {}));
    }
    Scene scene = wall_scene(balls, integrator, dt);
    scene.half_extent = {1.0, 1.0, drop_depth};
    scene.settings.laws.gravity = true;
    return scene;
}

Scene gas_scene(Integrator integrator, double dt, std::uint32_t count) {
    Scene scene = scene_of({}, integrator, dt);
    const double volume = 4.0 / 3.0 * std::numbers::pi * gas_radius * gas_radius * gas_radius;
    scene.half_extent = dvec3(0.5 * std::cbrt(count * volume / 0.1));
    Fill fill;
    fill.count = count;
    fill.radius = {gas_radius, gas_radius};
    fill.density = 1.0 / volume;
    fill.speed = std::sqrt(3.0);
    fill.region = {-scene.half_extent, scene.half_extent};
    scene.fill = fill;
    scene.settings.balls = count;
    scene.settings.stiffness = gas_stiffness;
    scene.settings.laws.contact = scene.settings.laws.walls = true;
    return scene;
}

Simulation start(const Machine& machine, const Scene& scene) { return {scene, scene.settings, 0, machine.make()}; }

void run(Simulation& simulation, int substeps) {
    for (int i = 0; i < substeps; ++i) {
        simulation.substep();
    }
}

int substeps_in(double time, double dt) { return static_cast<int>(std::lround(time / dt)); }

Motion motion_of(Simulation& simulation) {
    if (auto* reference = dynamic_cast<cpu::CpuBackend<double>*>(&simulation.backend())) {
        return {in_double(reference->positions()), exact_velocities(simulation, *reference)};
    }
    const BallState state = simulation.synchronised_state();
    return {in_double(state.positions), in_double(state.velocities)};
}

Motion motion_after(const Machine& machine, const Scene& scene, double time) {
    Simulation simulation = start(machine, scene);
    run(simulation, substeps_in(time, scene.settings.dt));
    return motion_of(simulation);
}

std::vector<dvec3> positions_of(Simulation& simulation) {
    if (auto* reference = dynamic_cast<cpu::CpuBackend<double>*>(&simulation.backend())) {
        return in_double(reference->positions());
    }
    return in_double(read_slot<vec4>(simulation.backend(), Slot::positions));
}

dvec3 bench(std::size_t i, double spacing) {
    const std::size_t whole = i / 8;
    const auto row = static_cast<double>(whole);
    const auto place = static_cast<double>(i % 8);
    return {0.0, spacing * (place - 3.5), spacing * (row - 3.5)};
}

std::vector<Collision> collide(const Machine& machine, const Settings& settings, std::vector<Encounter> encounters,
                               int substeps) {
    std::vector<BallSpec> balls;
    std::vector<Collision> collisions(encounters.size());
    double reach = 0.0;
    for (const Encounter& encounter : encounters) {
        reach = std::max(reach, encounter.left.radius + encounter.right.radius);
    }
    for (std::size_t i = 0; i < encounters.size(); ++i) {
        Encounter& e = encounters[i];
        const double closing = e.left.velocity.x - e.right.velocity.x;
        const double touching = e.left.radius + e.right.radius;
        const double apart =
            std::sqrt(touching * touching - e.offset * e.offset) + closing * settings.dt * (3.0 + e.phase);
        const dvec3 half(0.5 * apart, 0.5 * e.offset, 0.0);
        e.left.position = bench(i, 3.0 * reach) - half;
        e.right.position = bench(i, 3.0 * reach) + half;
        balls.push_back(e.left);
        balls.push_back(e.right);
        collisions[i].left = e.left;
        collisions[i].right = e.right;
    }
    Scene scene = scene_of(std::move(balls), settings.integrator, settings.dt);
    scene.half_extent = dvec3(2.0, 12.0 * reach, 12.0 * reach);
    const auto count = scene.settings.balls;
    scene.settings = settings;
    scene.settings.balls = count;
    scene.settings.laws.contact = true;
    Simulation simulation = start(machine, scene);
    const BallState begin = simulation.raw_state();
    for (std::size_t i = 0; i < collisions.size(); ++i) {
        place_as_stored(collisions[i].left, begin.positions[2 * i]);
        place_as_stored(collisions[i].right, begin.positions[2 * i + 1]);
    }
    for (int step = 0; step < substeps; ++step) {
        simulation.substep();
        const std::vector<dvec3> x = positions_of(simulation);
        for (std::size_t i = 0; i < collisions.size(); ++i) {
            const double radii = collisions[i].left.radius + collisions[i].right.radius;
            const double overlap = radii - glm::length(x[2 * i + 1] - x[2 * i]);
            collisions[i].max_overlap = std::max(collisions[i].max_overlap, overlap);
            collisions[i].duration += overlap > 0.0 ? settings.dt : 0.0;
        }
    }
    const Motion end = motion_of(simulation);
    for (std::size_t i = 0; i < collisions.size(); ++i) {
        Collision& c = collisions[i];
        c.x = {end.x[2 * i], end.x[2 * i + 1]};
        c.v = {end.v[2 * i], end.v[2 * i + 1]};
        c.restitution = (c.v[1].x - c.v[0].x) / (c.left.velocity.x - c.right.velocity.x);
        c.time = substeps * settings.dt;
    }
    return collisions;
}

std::vector<Encounter> at_64_phases(const BallSpec& left, const BallSpec& right, double offset) {
    std::vector<Encounter> encounters;
    encounters.reserve(64);
    for (int i = 0; i < 64; ++i) {
        encounters.push_back({left, right, offset, (i + 0.5) / 64.0});
    }
    return encounters;
}

}  // namespace ballpit::test
