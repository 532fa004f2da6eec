// Scenes at random, at the ends of what a scene file may hold as often as in the middle.
#include <algorithm>
#include <array>
#include <cmath>

#include "core/scene_sections.h"
#include "core/stepper.h"
#include "core/text.h"
#include "support/dice.h"
#include "support/fuzz_case.h"

namespace ballpit::test {

namespace {

constexpr std::uint32_t most_balls = 300;

double clamped(double value, double low, double high) { return std::clamp(value, low, high); }

double coordinate(Dice& dice, double half, double radius) {
    switch (dice.below(8)) {
        case 0:
            return half;  // on the wall
        case 1:
            return 0.0;
        case 2:  // a multiple of the diameter: on the faces of cells
            return clamped(2.0 * radius * std::round(dice.between(-half, half) / (2.0 * radius)), -half, half);
        default:
            return dice.between(-half, half);
    }
}

dvec3 place(Dice& dice, const dvec3& half, double radius) {
    return {coordinate(dice, half.x, radius), coordinate(dice, half.y, radius), coordinate(dice, half.z, radius)};
}

double speed(Dice& dice, double extreme) {
    if (dice.chance(0.2)) {
        return 0.0;
    }
    const double size = dice.chance(extreme) ? dice.decades(1e-6, largest_speed) : dice.decades(1e-2, 10.0);
    return dice.chance(0.5) ? size : -size;
}

struct Style {
    double extreme = 0.0;  // how often a number is taken from the whole range
    double radius = 0.1;   // m, usual
    bool equal_radii = true;
    bool equal_masses = true;
};

double radius(Dice& dice, const Style& style) {
    const double usual = style.equal_radii ? style.radius : style.radius * dice.between(0.3, 1.0);
    return dice.chance(0.3 * style.extreme) ? dice.decades(smallest_length, largest_length)
                                            : clamped(usual, smallest_length, largest_length);
}

double mass(Dice& dice, const Style& style) {
    return dice.chance(0.3 * style.extreme) ? dice.decades(smallest_mass, largest_mass)
                                            : (style.equal_masses ? 1.0 : dice.decades(0.1, 10.0));
}

BallSpec ball(Dice& dice, const Style& style, const dvec3& half) {
    BallSpec spec;
    spec.radius = radius(dice, style);
    spec.mass = mass(dice, style);
    spec.position = place(dice, half, spec.radius);
    spec.velocity = {speed(dice, style.extreme), speed(dice, style.extreme), speed(dice, style.extreme)};
    return spec;
}

Style make_style(Dice& dice, const dvec3& half, std::uint32_t balls) {
    Style style;
    style.extreme = dice.chance(0.3) ? 0.5 : dice.chance(0.5) ? 0.05 : 0.0;
    // From almost empty to three times as full as it can be.
    const double share = dice.decades(0.003, 3.0);
    const double volume = 8.0 * half.x * half.y * half.z * share / std::max(1u, balls);
    const double narrow = std::min({half.x, half.y, half.z});
    style.radius = std::min(std::cbrt(volume * 3.0 / 12.566), dice.chance(0.05) ? 2.0 * narrow : 0.7 * narrow);
    style.equal_radii = dice.chance(0.5);
    style.equal_masses = dice.chance(0.5);
    return style;
}

std::uint32_t ball_count(Dice& dice) {
    const double kind = dice.unit();
    if (kind < 0.2) {
        return static_cast<std::uint32_t>(dice.below(3));
    }
    if (kind < 0.9) {
        return static_cast<std::uint32_t>(dice.decades(3.0, 60.0));
    }
    return 60 + static_cast<std::uint32_t>(dice.below(most_balls - 59));
}

dvec3 half_extent(Dice& dice) {
    const double size = dice.chance(0.15) ? dice.decades(smallest_length, largest_length) : dice.decades(0.2, 5.0);
    const auto side = [&] {
        return clamped(size * (dice.chance(0.5) ? 1.0 : dice.between(0.3, 1.0)), smallest_length, largest_length);
    };
    return {side(), side(), side()};
}

void make_laws(Dice& dice, Settings& settings) {
    Laws& laws = settings.laws;
    laws.gravity = dice.chance(0.5);
    laws.drag = dice.chance(0.3);
    laws.contact = dice.chance(0.8);
    laws.walls = laws.contact ? dice.chance(0.7) : dice.chance(0.4);
    laws.restitution = (laws.contact || laws.walls) && dice.chance(0.6);
    laws.shake = laws.walls && dice.chance(0.1);
    laws.diagnostics = dice.chance(0.9);
    laws.compensated = dice.chance(0.15);
}

void make_numbers(Dice& dice, Settings& settings) {
    const bool extreme = dice.chance(0.2);
    const auto axis = [&] { return dice.chance(0.7) ? 0.0 : dice.between(-100.0, 100.0); };
    settings.gravity = dice.chance(0.7) ? dvec3(0, 0, -9.8) : dvec3(axis(), axis(), axis());
    settings.drag = dice.chance(0.2) ? dice.decades(1e-3, 100.0) : dice.decades(0.01, 1.0);
    settings.stiffness = dice.chance(0.05) ? 0.0 : extreme ? dice.decades(1e-3, 1e8) : dice.decades(10.0, 1e5);
    settings.restitution = settings.laws.restitution ? dice.between(0.05, 1.0) : 1.0;
    settings.limit_force = dice.chance(0.8);
    settings.substeps = static_cast<std::uint32_t>(dice.decades(1.0, extreme ? 1024.0 : 20.0));
    settings.dt = dice.chance(0.03) ? 0.0 : extreme ? dice.decades(1e-6, 1.0) : dice.decades(1e-3, 0.03);
    settings.integrator =
        dice.chance(0.5) ? Integrator::leapfrog : static_cast<Integrator>(dice.below(integrator_names.size()));
    settings.sort = static_cast<SortMethod>(dice.below(sort_names.size()));
    settings.cell_factor = dice.chance(0.7) ? 1.0 : dice.decades(0.25, 8.0);
    settings.neighbours = dice.chance(0.85) ? NeighbourSearch::grid : NeighbourSearch::brute_force;
    settings.grid_reuse = dice.chance(0.85) ? 1 : static_cast<std::uint32_t>(dice.decades(2.0, 64.0));
    if (settings.laws.shake) {
        settings.shake_amplitude = {axis() / 100.0, 0.0, dice.between(-0.2, 0.2)};
        settings.shake_frequency = dice.decades(0.01, 100.0);
    }
}

void make_balls(Dice& dice, Scene& scene, const Style& style, std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
        scene.balls.push_back(ball(dice, style, scene.half_extent));
        if (i > 0 && dice.chance(0.05)) {  // the same place as another, bit for bit
            scene.balls.back().position = scene.balls[dice.below(i)].position;
        }
        if ((scene.settings.laws.contact || scene.settings.laws.walls) && dice.chance(0.02)) {
            scene.balls.back().restitution = dice.between(0.05, 1.0);
        }
    }
}

// A saved moment, in which balls may be anywhere and as fast as they are.
void make_resume(Dice& dice, Scene& scene) {
    scene.resume = Resume{dice.below(1000), static_cast<std::uint32_t>(dice.below(scene.settings.substeps)),
                          dice.decades(1e-3, 1e3), 0.5 * scene.settings.dt / scene.settings.substeps, WallShift{}};
    for (BallSpec& spec : scene.balls) {
        if (dice.chance(0.1)) {
            spec.position[static_cast<int>(dice.below(3))] = (dice.chance(0.5) ? 1.0 : -1.0) * dice.decades(1.0, 1e30);
        }
        if (dice.chance(0.05)) {
            spec.velocity[static_cast<int>(dice.below(3))] = (dice.chance(0.5) ? 1.0 : -1.0) * dice.decades(1.0, 1e30);
        }
    }
}

std::string random_setting(Dice& dice, const SettingInfo& info) {
    const auto number = [&] {
        const double low = std::max(info.minimum, 1e-3);
        return info.logarithmic ? dice.decades(low, info.maximum) : dice.between(info.minimum, info.maximum);
    };
    if (const auto choices = setting_choices(info); !choices.empty()) {
        return std::string(choices[dice.below(choices.size())]);
    }
    if (info.key == "balls") {
        return std::to_string(dice.below(most_balls));
    }
    if (info.key == "laws") {
        Settings settings;
        make_laws(dice, settings);
        return laws_text(settings.laws);
    }
    if (info.key == "pull") {
        return dice.chance(0.3)
                   ? "none"
                   : std::to_string(dice.below(40)) + "," + shortest_text(dice.between(-2.0, 2.0)) + ",0.5,0";
    }
    if (std::holds_alternative<bool Settings::*>(info.member)) {
        return dice.chance(0.5) ? "true" : "false";
    }
    if (std::holds_alternative<std::uint32_t Settings::*>(info.member)) {
        return std::to_string(static_cast<std::uint32_t>(dice.decades(1.0, 64.0)));
    }
    if (std::holds_alternative<dvec3 Settings::*>(info.member)) {
        return shortest_text(number()) + "," + shortest_text(0.01 * number()) + "," + shortest_text(number());
    }
    return shortest_text(number());
}

FuzzAction action(Dice& dice, const FuzzCase& fuzz_case, const Style& style) {
    FuzzAction action;
    action.at = static_cast<std::uint32_t>(dice.below(fuzz_case.substeps + 1));
    const double kind = dice.unit();
    if (kind < 0.6) {
        const SettingInfo& info = setting_table()[dice.below(setting_table().size())];
        action.text = "set " + std::string(info.key) + "=" + random_setting(dice, info);
    } else if (kind < 0.75) {
        const BallSpec spec = ball(dice, style, fuzz_case.scene.half_extent);
        action.text = "add";
        for (const double number : {spec.position.x, spec.position.y, spec.position.z, spec.velocity.x, spec.velocity.y,
                                    spec.velocity.z, spec.radius, spec.mass}) {
            action.text += " " + shortest_text(number);
        }
    } else {
        action.text = "back " + std::string(step_unit_names[dice.below(step_unit_names.size())]) + " " +
                      std::to_string(1 + dice.below(4));
    }
    return action;
}

}  // namespace

FuzzCase make_fuzz_case(std::uint64_t seed, std::uint64_t number) {
    Dice dice(seed, number);
    FuzzCase result;
    Scene& scene = result.scene;
    scene.name = "fuzz " + std::to_string(seed) + " " + std::to_string(number);
    scene.half_extent = half_extent(dice);
    make_laws(dice, scene.settings);
    make_numbers(dice, scene.settings);
    const std::uint32_t count = ball_count(dice);
    const Style style = make_style(dice, scene.half_extent, count);
    const bool filled = dice.chance(0.3);
    make_balls(dice, scene, style, filled ? count / 2 : count);
    if (filled || scene.balls.empty() || dice.chance(0.2)) {
        const double radius = clamped(style.radius, smallest_length, largest_length);
        scene.fill = Fill{filled ? count - count / 2 : 0,
                          {style.equal_radii ? radius : std::max(smallest_length, 0.4 * radius), radius},
                          dice.decades(0.1, 1e4),
                          dice.chance(0.5) ? 0.0 : dice.decades(0.01, 10.0),
                          {-scene.half_extent, scene.half_extent},
                          number};
    }
    if (!scene.balls.empty() && dice.chance(0.1)) {
        make_resume(dice, scene);
    }
    scene.settings.balls = count;
    result.seed = 1 + dice.below(100);
    result.substeps = 1 + static_cast<std::uint32_t>(dice.below(count > 60 ? 10 : 30));
    const std::size_t actions = dice.chance(0.5) ? 0 : 1 + dice.below(3);
    for (std::size_t i = 0; i < actions; ++i) {
        result.actions.push_back(action(dice, result, style));
    }
    std::ranges::stable_sort(result.actions, {}, &FuzzAction::at);
    return result;
}

}  // namespace ballpit::test
