#include "core/scene_writer.h"

#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/json_document.h"
#include "core/quarantine.h"
#include "core/scene_sections.h"

namespace ballpit {

namespace {

using Json = nlohmann::ordered_json;

Json vector_json(const dvec3& v) { return {v.x, v.y, v.z}; }

Json box_json(const Scene& scene) {
    const Settings& settings = scene.settings;
    const Settings usual;
    Json box{{"half_extent", vector_json(scene.half_extent)}};
    if (scene.reference_count != 0) {
        box["reference_count"] = scene.reference_count;
    }
    if (settings.walls_low != usual.walls_low) {
        box["walls_low"] = vector_json(settings.walls_low);
    }
    if (settings.walls_high != usual.walls_high) {
        box["walls_high"] = vector_json(settings.walls_high);
    }
    if (settings.wall_speed != usual.wall_speed) {
        box["wall_speed"] = settings.wall_speed;
    }
    return box;
}

Json spring_json(const Settings& settings) {
    Json spring{{"stiffness", settings.stiffness}};
    if (settings.laws.restitution) {
        spring["restitution"] = settings.restitution;
    }
    spring["limit_force"] = settings.limit_force;
    if (settings.dashpot != Settings().dashpot) {
        spring["dashpot"] = dashpot_names.at(static_cast<std::size_t>(settings.dashpot));
    }
    return spring;
}

Json laws_json(const Settings& settings) {
    Json laws = Json::object();
    if (settings.laws.gravity) {
        laws["gravity"] = vector_json(settings.gravity);
    }
    if (settings.laws.drag) {
        laws["drag"] = settings.drag;
    }
    if (settings.laws.contact) {
        laws["contact"] = spring_json(settings);
    }
    if (settings.laws.walls) {
        laws["walls"] = settings.laws.contact ? Json(true) : spring_json(settings);
    }
    if (settings.laws.walls && settings.laws.shake) {
        laws["shake"] = {{"amplitude", vector_json(settings.shake_amplitude)}, {"frequency", settings.shake_frequency}};
    }
    if (!settings.laws.diagnostics) {
        laws["diagnostics"] = false;
    }
    if (settings.laws.compensated) {
        laws["compensated"] = true;
    }
    return laws;
}

Json time_json(const Settings& settings) {
    return {{"dt", settings.dt},
            {"substeps", settings.substeps},
            {"integrator", integrator_names.at(static_cast<std::size_t>(settings.integrator))}};
}

// Empty where it is computed as usual.
Json compute_json(const Settings& settings) {
    const Settings usual;
    Json compute = Json::object();
    if (settings.sort != usual.sort) {
        compute["sort"] = sort_names.at(static_cast<std::size_t>(settings.sort));
    }
    if (settings.cell_factor != usual.cell_factor) {
        compute["cell_factor"] = settings.cell_factor;
    }
    if (settings.grid_reuse != usual.grid_reuse) {
        compute["grid_reuse"] = settings.grid_reuse;
    }
    if (settings.neighbours != usual.neighbours) {
        compute["neighbours"] = neighbour_search_names.at(static_cast<std::size_t>(settings.neighbours));
    }
    if (settings.sorted_copies != usual.sorted_copies) {
        compute["sorted_copies"] = settings.sorted_copies;
    }
    if (settings.keep_order != usual.keep_order) {
        compute["keep_order"] = settings.keep_order;
    }
    return compute;
}

Json fill_json(const Fill& fill) {
    return {{"count", fill.count},
            {"radius", {fill.radius[0], fill.radius[1]}},
            {"density", fill.density},
            {"speed", fill.speed},
            {"region", {vector_json(fill.region[0]), vector_json(fill.region[1])}},
            {"seed", fill.seed}};
}

Json resume_json(const Resume& resume) {
    return {{"step", resume.step},
            {"substep", resume.substep},
            {"time", resume.time},
            {"velocity_lag", resume.velocity_lag},
            {"walls_low", vector_json(resume.walls.low)},
            {"walls_high", vector_json(resume.walls.high)},
            {"shake_offset", vector_json(resume.walls.shake)},
            {"shake_phase", resume.walls.shake_phase}};
}

// A zero below zero stays one: JSON's -0 would be a whole number, which has none.
std::string number_text(double value) {
    const auto single = static_cast<float>(value);
    if (static_cast<double>(single) != value) {
        return shortest_text(value);
    }
    if (value == 0.0) {
        return std::signbit(value) ? "-0.0" : "0";
    }
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), single).ptr;
    double read_back = 0.0;  // by way of a double, as the parser does
    std::from_chars(text.data(), end, read_back);
    return static_cast<float>(read_back) == single ? std::string(text.data(), end) : shortest_text(value);
}

std::string vector_text(const dvec3& v) {
    return "[" + number_text(v.x) + ", " + number_text(v.y) + ", " + number_text(v.z) + "]";
}

std::string compensation_text(const Compensation& c) {
    std::string text;
    for (const float left : {c.x, c.y, c.z, c.vx, c.vy, c.vz}) {
        text += (text.empty() ? "" : ", ") + number_text(static_cast<double>(left));
    }
    return "[" + text + "]";
}

std::string ball_text(const BallSpec& ball) {
    return R"({ "position": )" + vector_text(ball.position) + R"(, "velocity": )" + vector_text(ball.velocity) +
           R"(, "radius": )" + number_text(ball.radius) + R"(, "mass": )" + number_text(ball.mass) +
           (ball.restitution ? R"(, "restitution": )" + shortest_text(*ball.restitution) : "") +
           (ball.compensation ? R"(, "compensation": )" + compensation_text(*ball.compensation) : "") +
           (ball.quarantined ? R"(, "quarantined": true)" : "") + " }";
}

// One line with spaces, as a person writes it.
std::string line(const Json& value) {
    if (value.is_array() || value.is_object()) {
        std::string inside;
        for (const auto& item : value.items()) {
            inside += inside.empty() ? "" : ", ";
            inside += value.is_object() ? Json(item.key()).dump() + ": " + line(item.value()) : line(item.value());
        }
        return value.is_array() ? "[" + inside + "]" : "{ " + inside + " }";
    }
    return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string member(const char* key, const Json& value) { return std::string(",\n  \"") + key + "\": " + line(value); }

std::string balls_text(const Scene& scene) {
    std::string text = ",\n  \"balls\": [";
    for (std::size_t i = 0; i < scene.balls.size(); ++i) {
        text += i == 0 ? "\n    " : ",\n    ";
        text += ball_text(scene.balls[i]);
    }
    return text + "\n  ]";
}

}  // namespace

std::string scene_text(const Scene& scene) {
    std::string text = "{\n  \"name\": " + line(scene.name);
    if (!scene.about.empty()) {
        text += member("about", scene.about);
    }
    text += member("box", box_json(scene)) + member("laws", laws_json(scene.settings)) +
            member("time", time_json(scene.settings));
    if (const Json compute = compute_json(scene.settings); !compute.empty()) {
        text += member("compute", compute);
    }
    if (scene.resume) {
        text += member("resume", resume_json(*scene.resume));
    }
    if (scene.fill) {
        text += member("fill", fill_json(*scene.fill));
    }
    if (!scene.balls.empty() || !scene.fill) {
        text += balls_text(scene);
    }
    return text + "\n}\n";
}

namespace {

void expect_finite(const vec4& position, const vec4& velocity, std::size_t ball) {
    const vec4 sum = position + velocity;
    if (!std::isfinite(sum.x + sum.y + sum.z + sum.w)) {
        throw InputError("the scene cannot be saved: ball " + std::to_string(ball) +
                         " has a position or velocity that is no number");
    }
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(static_cast<double>(position[axis])) > largest_number ||
            std::abs(static_cast<double>(velocity[axis])) > largest_number) {
            throw InputError("the scene cannot be saved: ball " + std::to_string(ball) +
                             " has a position or velocity beyond " + shortest_text(largest_number));
        }
    }
}

}  // namespace

Scene scene_as_set(const Simulation& simulation) {
    Scene scene = simulation.scene();
    scene.settings = simulation.settings();
    scene.settings.pull.reset();
    const std::size_t wanted = scene.settings.balls - simulation.added();
    if (scene.balls.size() > wanted) {
        scene.balls.resize(wanted);
    }
    if (scene.fill) {
        scene.fill->count = static_cast<std::uint32_t>(wanted - scene.balls.size());
        scene.fill->seed = simulation.seed();
    }
    return scene;
}

Scene scene_of_moment(Simulation& simulation) {
    const BallState state = simulation.raw_state();
    const std::vector<BallSpec>& listed = simulation.scene().balls;
    Scene scene = simulation.scene();
    const double wide = widening(scene, state.count());
    scene.half_extent = simulation.scene_box().half_extent();
    scene.reference_count = 0;
    scene.settings = simulation.settings();
    scene.settings.pull.reset();
    scene.resume = Resume{simulation.step_count(), simulation.substep_in_step(), simulation.time(),
                          simulation.velocity_lag(), simulation.wall_shift()};
    scene.balls.clear();
    scene.balls.reserve(state.count());
    const bool touching = scene.settings.laws.contact || scene.settings.laws.walls;  // else nobody asks how they bounce
    for (std::uint32_t i = 0; i < state.count(); ++i) {
        const vec4& position = state.positions[i];
        const vec4& velocity = state.velocities[i];
        expect_finite(position, velocity, i);
        scene.balls.push_back({dvec3(position), dvec3(velocity), std::abs(static_cast<double>(position.w)),
                               static_cast<double>(velocity.w),
                               touching && i < listed.size() ? listed[i].restitution : std::nullopt,
                               state.compensations.empty() ? std::nullopt : std::optional(state.compensations[i]),
                               in_quarantine(position)});
    }
    if (scene.fill) {
        const dvec3 scale{wide, wide, 1.0};
        scene.fill->count = 0;
        scene.fill->seed = simulation.seed();
        scene.fill->region = {scene.fill->region[0] * scale, scene.fill->region[1] * scale};
    }
    return scene;
}

}  // namespace ballpit
