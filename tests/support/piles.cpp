#include "support/piles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/contact.h"
#include "core/random.h"
#include "cpu/cpu_backend.h"
#include "measure/pairs.h"
#include "measure/stability.h"

namespace ballpit::test {

namespace {

constexpr double stiffness = 1e4;     // N/m
constexpr double radius = 0.05;       // m, of the larger balls
constexpr double settling_dt = 1e-3;  // s
constexpr double at_rest = 5e-9;      // of weight_energy: rounding keeps 1e-9 to 3e-9 moving
constexpr int patience = 200;         // s

Scene pile_scene(bool unequal_radii, std::uint32_t balls) {
    Scene scene;
    const double side = radius * std::cbrt(static_cast<double>(balls)) * 1.6;
    scene.half_extent = {0.6 * side, 0.6 * side, 3.0 * side};
    Settings& settings = scene.settings;
    settings.laws = parse_laws("gravity,contact,restitution,walls");
    settings.balls = balls;
    settings.stiffness = stiffness;
    settings.restitution = 0.3;  // to settle soon, and with room between settling_dt and dt_c
    settings.substeps = 1;
    settings.dt = settling_dt;
    scene.fill = Fill{balls,
                      {unequal_radii ? 0.5 * radius : radius, radius},
                      1.0 / (4.0 / 3.0 * std::numbers::pi * radius * radius * radius),  // the larger ones have 1 kg
                      0.0,
                      {-scene.half_extent, scene.half_extent},
                      7};
    return scene;
}

// In coordinates times the root of the mass, in which masses are 1.
struct Contact {
    std::size_t a;
    std::size_t b;
    dvec3 of_a;  // the normal over the root of the mass of a
    dvec3 of_b;  // zero for a wall
    double dashpot;
};

double mass_of(const SettledPile& pile, std::size_t ball) { return static_cast<double>(pile.state.velocities[ball].w); }

Contact contact_of(const SettledPile& pile, std::size_t a, std::size_t b, const dvec3& normal, bool wall) {
    const Settings& settings = pile.scene.settings;
    const double restitution = settings.laws.restitution ? settings.restitution : 1.0;
    const double zeta = damping_ratio_from_restitution(restitution, settings.limit_force);
    const double lightness = 1.0 / mass_of(pile, a) + (wall ? 0.0 : 1.0 / mass_of(pile, b));
    return {a, b, normal / std::sqrt(mass_of(pile, a)), wall ? dvec3(0.0) : normal / std::sqrt(mass_of(pile, b)),
            2.0 * zeta * std::sqrt(stiffness / lightness)};
}

std::vector<Contact> contacts_of(const SettledPile& pile) {
    std::vector<Contact> contacts;
    for (const measure::Pair& pair : measure::touching_pairs(pile.state.positions)) {
        const dvec3 offset(pile.state.positions[pair.a] - pile.state.positions[pair.b]);
        contacts.push_back(contact_of(pile, pair.a, pair.b, glm::normalize(offset), false));
    }
    for (std::size_t i = 0; i < pile.state.count(); ++i) {
        const vec4& p = pile.state.positions[i];
        for (int axis = 0; axis < 3; ++axis) {
            if (static_cast<double>(std::abs(p[axis]) + p.w) > pile.scene.half_extent[axis]) {
                dvec3 normal(0.0);
                normal[axis] = p[axis] < 0.0f ? 1.0 : -1.0;
                contacts.push_back(contact_of(pile, i, i, normal, true));
            }
        }
    }
    return contacts;
}

Simulation resumed(const SettledPile& pile, double dt) {
    Scene scene = pile.scene;
    scene.settings.dt = dt;
    scene.fill.reset();
    for (std::size_t i = 0; i < pile.state.count(); ++i) {
        const vec4& p = pile.state.positions[i];
        scene.balls.push_back(
            {dvec3(p), dvec3(pile.state.velocities[i]), static_cast<double>(p.w), mass_of(pile, i), std::nullopt});
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

SettledPile settled_pile(bool unequal_radii, std::uint32_t balls) {
    SettledPile pile{pile_scene(unequal_radii, balls), {}, 0.0};
    Simulation simulation(pile.scene, pile.scene.settings, 7, std::make_unique<cpu::CpuBackend<float>>());
    pile.state = simulation.synchronised_state();
    for (std::size_t i = 0; i < pile.state.count(); ++i) {
        pile.weight_energy += 9.8 * mass_of(pile, i) * static_cast<double>(pile.state.positions[i].w);
    }
    const auto rests = [&] { return record_of(simulation).reading.kinetic < at_rest * pile.weight_energy; };
    for (int second = 1; second <= 3 || !rests(); ++second) {  // at first all of them hang in the air
        if (second > patience) {
            throw std::runtime_error("a pile has not come to rest");
        }
        for (int i = 0; i < 1000; ++i) {
            simulation.substep();
        }
    }
    pile.state = simulation.synchronised_state();
    return with_restitution(std::move(pile), 1.0);
}

SettledPile with_restitution(SettledPile pile, double restitution) {
    pile.scene.settings.restitution = restitution;
    pile.scene.settings.laws.restitution = restitution < 1.0;
    return pile;
}

SettledPile kicked(SettledPile pile, double share) {
    for (std::size_t i = 0; i < pile.state.count(); ++i) {
        vec4& v = pile.state.velocities[i];
        const double z = 2.0 * random_unit(1, 0, static_cast<std::uint32_t>(i)) - 1.0;
        const double angle = 2.0 * std::numbers::pi * random_unit(1, 1, static_cast<std::uint32_t>(i));
        const double flat = std::sqrt(1.0 - z * z);
        const double speed = std::sqrt(2.0 * share * 9.8 * static_cast<double>(pile.state.positions[i].w));
        v = vec4(vec3(speed * dvec3(flat * std::cos(angle), flat * std::sin(angle), z)), v.w);
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
    double dt = 1.0 / std::sqrt(stiffness);
    for (int round = 0; round < 6000; ++round) {
        std::vector<dvec3> image(mode.size(), dvec3(0.0));
        double springs = 0.0;
        double dashpots = 0.0;
        double square = 0.0;
        for (const Contact& c : contacts) {
            const double stretch = glm::dot(c.of_a, mode[c.a]) - glm::dot(c.of_b, mode[c.b]);
            const double force = (0.25 * dt * dt * stiffness + 0.5 * dt * c.dashpot) * stretch;
            image[c.a] += force * c.of_a;
            image[c.b] -= force * c.of_b;
            springs += stiffness * stretch * stretch;
            dashpots += c.dashpot * stretch * stretch;
        }
        for (const dvec3& x : mode) {
            square += glm::dot(x, x);
        }
        // The substep at which this very mode would be the one on the edge: dt^2 K / 4 + dt C / 2 = 1.
        const double half = dashpots / square;
        dt = 2.0 / (std::sqrt(0.25 * half * half + springs / square) + 0.5 * half);
        const double scale = 1.0 / std::sqrt(square);
        std::ranges::transform(image, mode.begin(), [scale](const dvec3& x) { return scale * x; });
    }
    return dt;
}

MeterReading reading_of(const SettledPile& pile) {
    Simulation simulation = resumed(pile, settling_dt);
    return record_of(simulation).reading;
}

double gauge_critical_dt(const SettledPile& pile) {
    Simulation simulation = resumed(pile, settling_dt);
    return settling_dt / measure::dt_over_critical(record_of(simulation), simulation.settings());
}

double shortest_contact(const SettledPile& pile) {
    double lightest = mass_of(pile, 0);
    for (std::size_t i = 1; i < pile.state.count(); ++i) {
        lightest = std::min(lightest, mass_of(pile, i));
    }
    return std::numbers::pi / std::sqrt(2.0 * stiffness / lightest);
}

std::vector<Course> course_of(const SettledPile& pile, double dt, std::span<const int> marks) {
    Simulation simulation = resumed(pile, dt);
    const double begin = record_of(simulation).reading.energy();
    std::vector<Course> course;
    double largest = 0.0;
    for (int i = 1; course.size() < marks.size(); ++i) {
        simulation.substep();
        const bool marked = i == marks[course.size()];
        if (marked || i % 5 == 0) {
            const MeterReading reading = record_of(simulation).reading;
            const double kinetic = reading.kinetic / pile.weight_energy;
            largest = std::isfinite(kinetic) ? std::max(largest, kinetic) : HUGE_VAL;
            if (marked) {
                course.push_back({largest, (reading.energy() - begin) / pile.weight_energy});
            }
        }
    }
    return course;
}

double agitation(const SettledPile& pile, double dt, int substeps) {
    return course_of(pile, dt, std::array{substeps}).front().agitation;
}

}  // namespace ballpit::test
