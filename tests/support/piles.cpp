#include "support/piles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "cpu/cpu_backend.h"
#include "measure/pairs.h"
#include "measure/stability.h"

namespace ballpit::test {

namespace {

constexpr double stiffness = 1e4;  // N/m
constexpr double radius = 0.05;    // m, of the larger balls

Scene pile_scene(const PileKind& kind, std::uint32_t balls) {
    Scene scene;
    const double side = radius * std::cbrt(static_cast<double>(balls)) * 1.6;
    scene.half_extent = {0.6 * side, 0.6 * side, 3.0 * side};
    Settings& settings = scene.settings;
    settings.laws = parse_laws("gravity,contact,restitution,walls");
    settings.balls = balls;
    settings.stiffness = stiffness;
    settings.restitution = 0.1;  // to settle soon
    settings.substeps = 1;
    settings.dt = 2e-4;
    scene.fill = Fill{balls,
                      {kind.unequal_radii ? 0.5 * radius : radius, radius},
                      1.0 / (4.0 / 3.0 * 3.14159265 * radius * radius * radius),  // the larger ones have 1 kg
                      0.0,
                      {dvec3(-scene.half_extent.x, -scene.half_extent.y, -scene.half_extent.z),
                       dvec3(scene.half_extent.x, scene.half_extent.y, scene.half_extent.z)},
                      7};
    return scene;
}

struct Contact {
    std::uint32_t a;
    std::int64_t b;  // -1: a wall
    dvec3 normal;
};

std::vector<Contact> contacts_of(const SettledPile& pile) {
    std::vector<Contact> contacts;
    for (const measure::Pair& pair : measure::touching_pairs(pile.state.positions)) {
        const dvec3 offset(pile.state.positions[pair.a] - pile.state.positions[pair.b]);
        contacts.push_back({pair.a, pair.b, glm::normalize(offset)});
    }
    for (std::uint32_t i = 0; i < pile.state.count(); ++i) {
        const vec4& p = pile.state.positions[i];
        for (int axis = 0; axis < 3; ++axis) {
            if (static_cast<double>(std::abs(p[axis]) + p.w) > pile.scene.half_extent[axis]) {
                dvec3 normal(0.0);
                normal[axis] = p[axis] < 0.0f ? 1.0 : -1.0;
                contacts.push_back({i, -1, normal});
            }
        }
    }
    return contacts;
}

Simulation resumed(const SettledPile& pile, double dt) {
    Scene scene = pile.scene;
    scene.settings.dt = dt;
    scene.fill.reset();
    for (std::uint32_t i = 0; i < pile.state.count(); ++i) {
        const vec4& p = pile.state.positions[i];
        const vec4& v = pile.state.velocities[i];
        scene.balls.push_back({dvec3(p), dvec3(v), static_cast<double>(p.w), static_cast<double>(v.w), std::nullopt});
    }
    return {scene, scene.settings, 1, std::make_unique<cpu::CpuBackend<float>>()};
}

MeterRecord record_of(Simulation& simulation) {
    simulation.set_metering(true);
    simulation.meter();
    const MeterRecord record = simulation.take_records().back();
    simulation.set_metering(false);
    return record;
}

}  // namespace

SettledPile settled_pile(const PileKind& kind, std::uint32_t balls) {
    SettledPile pile{pile_scene(kind, balls), {}, 0.0};
    Simulation simulation(pile.scene, pile.scene.settings, 7, std::make_unique<cpu::CpuBackend<float>>());
    for (int i = 0; i < 8000; ++i) {
        simulation.substep();
    }
    pile.state = simulation.synchronised_state();
    pile.scene.settings.restitution = kind.restitution;
    pile.scene.settings.laws.restitution = kind.restitution < 1.0;
    for (std::size_t i = 0; i < pile.state.positions.size(); ++i) {
        pile.weight_energy += 9.8 * static_cast<double>(pile.state.velocities[i].w * pile.state.positions[i].w);
    }
    return pile;
}

double true_critical_dt(const SettledPile& pile) {
    const std::vector<Contact> contacts = contacts_of(pile);
    std::vector<dvec3> mode(pile.state.count());
    for (std::size_t i = 0; i < mode.size(); ++i) {
        const auto x = static_cast<double>(i);
        mode[i] = {std::sin(x), std::cos(2.0 * x), std::sin(3.0 * x + 1.0)};
    }
    double eigenvalue = 0.0;
    for (int round = 0; round < 3000; ++round) {
        std::vector<dvec3> image(mode.size(), dvec3(0.0));
        const auto scale = [&](std::size_t i) {
            return 1.0 / std::sqrt(static_cast<double>(pile.state.velocities[i].w));
        };
        for (const Contact& c : contacts) {
            double stretch = glm::dot(c.normal, mode[c.a]) * scale(c.a);
            if (c.b >= 0) {
                const auto b = static_cast<std::size_t>(c.b);
                stretch -= glm::dot(c.normal, mode[b]) * scale(b);
                image[b] -= stiffness * stretch * scale(b) * c.normal;
            }
            image[c.a] += stiffness * stretch * scale(c.a) * c.normal;
        }
        double square = 0.0;
        for (const dvec3& x : image) {
            square += glm::dot(x, x);
        }
        eigenvalue = std::sqrt(square);
        for (std::size_t i = 0; i < mode.size(); ++i) {
            mode[i] = image[i] / eigenvalue;
        }
    }
    return 2.0 / std::sqrt(eigenvalue);
}

double gauge_of(const SettledPile& pile, double dt) {
    Simulation simulation = resumed(pile, dt);
    return measure::dt_over_critical(record_of(simulation), simulation.settings());
}

double agitation(const SettledPile& pile, double dt, int substeps) {
    Simulation simulation = resumed(pile, dt);
    double largest = 0.0;
    for (int i = 0; i < substeps; i += 10) {
        for (int j = 0; j < 10; ++j) {
            simulation.substep();
        }
        const double kinetic = record_of(simulation).reading.kinetic / pile.weight_energy;
        largest = std::max(largest, std::isfinite(kinetic) ? kinetic : std::numeric_limits<double>::infinity());
    }
    return largest;
}

}  // namespace ballpit::test
