#include "core/scene_file.h"

#include <cmath>
#include <fstream>
#include <limits>

#include "core/error.h"
#include "core/scene_sections.h"

namespace ballpit {

namespace {

constexpr std::size_t largest_file = std::size_t{1} << 30;
constexpr double smallest_density = 1e-3;  // kg/m^3
constexpr double largest_density = 1e6;    // kg/m^3

std::string inside_text(double half) {
    return "a place inside the box, from " + shortest_text(-half) + " to " + shortest_text(half) + " m";
}

void expect_inside(const JsonValue& value, const dvec3& point, const Scene& scene) {
    for (int axis = 0; axis < 3; ++axis) {
        const double half = scene.half_extent[axis];
        if (std::abs(point[axis]) > half) {
            value.element(static_cast<std::size_t>(axis)).refuse(inside_text(half));
        }
    }
}

Compensation read_compensation(const JsonValue& list) {
    if (list.expect_array() != 6) {
        list.refuse("a list of six numbers");
    }
    const auto number = [&](std::size_t i) {
        return static_cast<float>(list.element(i).number_between(-largest_number, largest_number, ""));
    };
    return {number(0), number(1), number(2), number(3), number(4), number(5)};
}

// All that one ball can be asked without the rest of the scene, which may stand behind it in the file.
BallSpec read_ball(const JsonValue& ball) {
    ball.expect_object({"position", "velocity", "radius", "mass", "restitution", "compensation", "quarantined"});
    BallSpec spec;
    spec.position = ball.required("position").vector_between(-largest_number, largest_number, "m");
    if (const auto velocity = ball.optional("velocity")) {
        spec.velocity = velocity->vector_between(-largest_number, largest_number, "m/s");
    }
    spec.radius = ball.required("radius").number_between(smallest_length, largest_length, "m");
    spec.mass = ball.required("mass").number_between(smallest_mass, largest_mass, "kg");
    if (const auto restitution = ball.optional("restitution")) {
        spec.restitution = read_setting(*restitution, "restitution");
    }
    if (const auto compensation = ball.optional("compensation")) {
        spec.compensation = read_compensation(*compensation);
    }
    if (const auto quarantined = ball.optional("quarantined")) {
        spec.quarantined = quarantined->boolean();
    }
    return spec;
}

[[noreturn]] void refuse_ball(const std::string& file, std::size_t ball, const std::string& place,
                              const std::string& expected, const std::string& found) {
    throw InputError(file + ", /balls/" + std::to_string(ball) + place + ": expected " + expected + ", found " + found);
}

// Where a scene may start; in a saved moment balls are wherever their motion took them.
void check_start(const Scene& scene, std::size_t ball, const std::string& file) {
    for (int axis = 0; axis < 3; ++axis) {
        const double half = scene.half_extent[axis];
        const double position = scene.balls[ball].position[axis];
        const double velocity = scene.balls[ball].velocity[axis];
        if (std::abs(position) > half) {
            refuse_ball(file, ball, "/position/" + std::to_string(axis), inside_text(half), shortest_text(position));
        }
        if (std::abs(velocity) > largest_speed) {
            refuse_ball(file, ball, "/velocity/" + std::to_string(axis),
                        range_text(-largest_speed, largest_speed, "m/s"), shortest_text(velocity));
        }
    }
}

void check_balls(const Scene& scene, const std::string& file) {
    const bool touch = scene.settings.laws.contact || scene.settings.laws.walls;
    for (std::size_t i = 0; i < scene.balls.size(); ++i) {
        if (!scene.resume) {
            check_start(scene, i, file);
        }
        if (scene.balls[i].restitution && !touch) {
            refuse_ball(file, i, "/restitution", "a law 'contact' or 'walls' beside a ball's restitution", "none");
        }
        if (scene.balls[i].compensation && !scene.settings.laws.compensated) {
            refuse_ball(file, i, "/compensation", "a law 'compensated' beside a ball's compensation", "none");
        }
    }
}

std::array<dvec3, 2> read_region(const JsonValue& region, const Scene& scene) {
    if (region.expect_array() != 2) {
        region.refuse("a list of two corners");
    }
    const std::array<dvec3, 2> corners{region.element(0).vector(), region.element(1).vector()};
    expect_inside(region.element(0), corners[0], scene);
    expect_inside(region.element(1), corners[1], scene);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double lower = corners[0][static_cast<int>(axis)];
        if (corners[1][static_cast<int>(axis)] < lower) {
            region.element(1).element(axis).refuse("an upper corner not below the lower one's " + shortest_text(lower) +
                                                   " m");
        }
    }
    return corners;
}

std::array<double, 2> read_radii(const JsonValue& radius) {
    if (radius.expect_array() != 2) {
        radius.refuse("a list of the smallest and the largest radius");
    }
    const double smallest = radius.element(0).number_between(smallest_length, largest_length, "m");
    const double largest = radius.element(1).number_between(smallest_length, largest_length, "m");
    if (largest < smallest) {
        radius.element(1).refuse("a largest radius not below the smallest, " + shortest_text(smallest) + " m");
    }
    return {smallest, largest};
}

Fill read_fill(const JsonValue& value, const Scene& scene) {
    value.expect_object({"count", "radius", "density", "speed", "region", "seed"});
    Fill fill;
    fill.count = static_cast<std::uint32_t>(value.required("count").whole_number(maximum_balls - scene.balls.size()));
    fill.radius = read_radii(value.required("radius"));
    if (const auto density = value.optional("density")) {
        fill.density = density->number_between(smallest_density, largest_density, "kg/m^3");
    }
    if (const auto speed = value.optional("speed")) {
        fill.speed = speed->number_between(0.0, largest_speed, "m/s");
    }
    const auto region = value.optional("region");
    fill.region = region ? read_region(*region, scene) : std::array{-scene.half_extent, scene.half_extent};
    if (const auto seed = value.optional("seed")) {
        fill.seed = seed->whole_number(std::numeric_limits<std::uint64_t>::max());
    }
    return fill;
}

std::string read_file(const std::filesystem::path& path) {
    const std::string file = path.string();
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) {
        throw InputError(file + ": expected a scene file, found a folder");
    }
    std::ifstream stream(path, std::ios::binary);
    if (!stream) {
        throw InputError(file + ": expected a scene file, found none that can be read");
    }
    const auto expect_size = [&](std::uintmax_t size) {
        if (size > largest_file) {
            throw InputError(file + ": expected a scene file of at most 1 GiB, found a larger one");
        }
    };
    std::string text;
    if (const auto size = std::filesystem::file_size(path, ignored); !ignored) {  // a pipe has none
        expect_size(size);
        text.reserve(static_cast<std::size_t>(size));
    }
    std::vector<char> block(1u << 16);
    while (stream.read(block.data(), static_cast<std::streamsize>(block.size())), stream.gcount() > 0) {
        text.append(block.data(), static_cast<std::size_t>(stream.gcount()));
        expect_size(text.size());
    }
    if (stream.bad()) {
        throw InputError(file + ": expected a scene file, found one that cannot be read to its end");
    }
    return text;
}

void read_title(const JsonValue& root, Scene& scene) {
    if (const auto schema = root.optional("$schema")) {
        schema->string();  // for editors
    }
    scene.name = root.required("name").string();
    if (scene.name.empty()) {
        root.required("name").refuse("a name");
    }
    if (const auto about = root.optional("about")) {
        scene.about = about->string();
    }
}

void read_section(const JsonValue& root, std::string_view key, void (*read)(const JsonValue&, Scene&), Scene& scene) {
    if (const auto section = root.optional(key)) {
        read(*section, scene);
    }
}

}  // namespace

Scene parse_scene(std::string_view text, const std::string& file) {
    Scene scene;
    const StreamedList balls{"balls", [&scene](const JsonValue& ball) {
                                 if (scene.balls.size() == maximum_balls) {
                                     ball.refuse("at most " + std::to_string(maximum_balls) + " balls", "one more");
                                 }
                                 scene.balls.push_back(read_ball(ball));
                             }};
    const nlohmann::json tree = parse_json(text, file, balls);
    const JsonValue root(tree, file);
    root.expect_object(
        {"$schema", "name", "about", "box", "laws", "time", "compute", "balls", "fill", "resume", "bounds"});
    read_title(root, scene);
    read_box(root.required("box"), scene);
    read_section(root, "laws", read_laws, scene);
    read_section(root, "time", read_time, scene);
    read_section(root, "compute", read_compute, scene);
    read_section(root, "resume", read_resume, scene);
    read_section(root, "bounds", read_bounds, scene);
    const auto list = root.optional("balls");
    if (list) {
        list->expect_array();
    }
    check_balls(scene, file);
    if (const auto fill = root.optional("fill")) {
        scene.fill = read_fill(*fill, scene);
    }
    if (scene.balls.empty() && !scene.fill && !(list && scene.resume)) {  // all balls of a saved moment may be gone
        root.refuse("'balls' or 'fill'", "neither");
    }
    scene.settings.balls = static_cast<std::uint32_t>(scene.balls.size()) + (scene.fill ? scene.fill->count : 0u);
    return scene;
}

Scene load_scene(const std::filesystem::path& path) { return parse_scene(read_file(path), path.string()); }

}  // namespace ballpit
