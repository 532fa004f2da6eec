#include "core/scene_file.h"

#include <algorithm>
#include <fstream>
#include <limits>

#include "core/contact.h"
#include "core/error.h"
#include "core/json_document.h"

namespace ballpit {

namespace {

constexpr std::size_t largest_file = 64u << 20;
// What single precision can still compute with: beyond these, forces overflow or positions stand still.
constexpr double smallest_length = 1e-3;   // m
constexpr double largest_length = 1e4;     // m
constexpr double largest_speed = 1e6;      // m/s
constexpr double smallest_mass = 1e-9;     // kg
constexpr double largest_mass = 1e12;      // kg
constexpr double smallest_density = 1e-3;  // kg/m^3
constexpr double largest_density = 1e6;    // kg/m^3

const SettingInfo& setting(std::string_view key) { return *find_setting(key); }

double read_setting(const JsonValue& value, std::string_view key) {
    check_range(setting(key), value.number(), value.place());
    return value.number();
}

double read_restitution(const JsonValue& value) { return read_setting(value, "restitution"); }

void read_box(const JsonValue& box, Scene& scene) {
    box.expect_object({"half_extent", "reference_count"});
    scene.half_extent = box.required("half_extent").vector_between(smallest_length, largest_length, "m");
    if (const auto count = box.optional("reference_count")) {
        scene.reference_count = static_cast<std::uint32_t>(count->whole_number(maximum_balls));
    }
}

void read_contact(const JsonValue& contact, Scene& scene) {
    contact.expect_object({"stiffness", "restitution", "limit_force"});
    scene.settings.laws.contact = true;
    scene.settings.stiffness = read_setting(contact.required("stiffness"), "stiffness");
    scene.settings.restitution = 1.0;
    if (const auto restitution = contact.optional("restitution")) {
        scene.settings.laws.restitution = true;
        scene.settings.restitution = read_restitution(*restitution);
    }
    if (const auto limit_force = contact.optional("limit_force")) {
        scene.settings.limit_force = limit_force->boolean();
    }
}

void read_laws(const JsonValue& laws, Scene& scene) {
    laws.expect_object({"gravity", "drag", "contact", "walls"});
    if (const auto gravity = laws.optional("gravity")) {
        const SettingInfo& info = setting("gravity");
        scene.settings.laws.gravity = true;
        scene.settings.gravity = gravity->vector_between(info.minimum, info.maximum, info.unit);
    }
    if (const auto drag = laws.optional("drag")) {
        scene.settings.laws.drag = true;
        scene.settings.drag = read_setting(*drag, "drag");
    }
    if (const auto contact = laws.optional("contact")) {
        read_contact(*contact, scene);
    }
    if (const auto walls = laws.optional("walls")) {
        scene.settings.laws.walls = walls->boolean();
        if (scene.settings.laws.walls && !scene.settings.laws.contact) {
            walls->refuse("a law 'contact' beside walls, whose stiffness they share", "none");
        }
    }
}

Integrator read_integrator(const JsonValue& value) {
    const std::string name = value.string();
    const auto found = std::ranges::find(integrator_names, std::string_view(name));
    if (found == integrator_names.end()) {
        std::string list;
        for (const std::string_view known : integrator_names) {
            list += (list.empty() ? "" : ", ") + std::string(known);
        }
        value.refuse("one of " + list);
    }
    return static_cast<Integrator>(found - integrator_names.begin());
}

void read_time(const JsonValue& time, Settings& settings) {
    time.expect_object({"dt", "substeps", "integrator"});
    if (const auto dt = time.optional("dt")) {
        settings.dt = read_setting(*dt, "dt");
    }
    if (const auto substeps = time.optional("substeps")) {
        settings.substeps =
            static_cast<std::uint32_t>(substeps->whole_number(std::numeric_limits<std::uint32_t>::max()));
        check_range(setting("substeps"), settings.substeps, substeps->place());
    }
    if (const auto integrator = time.optional("integrator")) {
        settings.integrator = read_integrator(*integrator);
    }
}

void expect_inside(const JsonValue& value, const dvec3& point, const Scene& scene) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double half = scene.half_extent[static_cast<int>(axis)];
        if (std::abs(point[static_cast<int>(axis)]) > half) {
            value.element(axis).refuse("a place inside the box, from " + shortest_text(-half) + " to " +
                                       shortest_text(half) + " m");
        }
    }
}

BallSpec read_ball(const JsonValue& ball, const Scene& scene) {
    ball.expect_object({"position", "velocity", "radius", "mass", "restitution"});
    BallSpec spec;
    spec.position = ball.required("position").vector();
    expect_inside(ball.required("position"), spec.position, scene);
    if (const auto velocity = ball.optional("velocity")) {
        spec.velocity = velocity->vector_between(-largest_speed, largest_speed, "m/s");
    }
    spec.radius = ball.required("radius").number_between(smallest_length, largest_length, "m");
    spec.mass = ball.required("mass").number_between(smallest_mass, largest_mass, "kg");
    if (const auto restitution = ball.optional("restitution")) {
        spec.restitution = read_restitution(*restitution);
        if (!scene.settings.laws.contact) {
            restitution->refuse("a law 'contact' beside a ball's restitution", "none");
        }
    }
    return spec;
}

void read_balls(const JsonValue& balls, Scene& scene) {
    const std::size_t count = balls.expect_array();
    if (count > maximum_balls) {
        balls.refuse("at most " + std::to_string(maximum_balls) + " balls");
    }
    scene.balls.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        scene.balls.push_back(read_ball(balls.element(i), scene));
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
    std::string text;
    std::array<char, 1 << 16> block{};
    while (stream.read(block.data(), block.size()), stream.gcount() > 0) {
        text.append(block.data(), static_cast<std::size_t>(stream.gcount()));
        if (text.size() > largest_file) {
            throw InputError(file + ": expected a scene file of at most 64 MiB, found a larger one");
        }
    }
    if (stream.bad()) {
        throw InputError(file + ": expected a scene file, found one that cannot be read to its end");
    }
    return text;
}

}  // namespace

Scene parse_scene(std::string_view text, const std::string& file) {
    const nlohmann::json tree = parse_json(text, file);
    const JsonValue root(tree, file);
    root.expect_object({"name", "about", "box", "laws", "time", "balls", "fill"});
    Scene scene;
    scene.name = root.required("name").string();
    if (scene.name.empty()) {
        root.required("name").refuse("a name");
    }
    if (const auto about = root.optional("about")) {
        scene.about = about->string();
    }
    read_box(root.required("box"), scene);
    if (const auto laws = root.optional("laws")) {
        read_laws(*laws, scene);
    }
    if (const auto time = root.optional("time")) {
        read_time(*time, scene.settings);
    }
    if (const auto balls = root.optional("balls")) {
        read_balls(*balls, scene);
    }
    if (const auto fill = root.optional("fill")) {
        scene.fill = read_fill(*fill, scene);
    }
    if (scene.balls.empty() && !scene.fill) {
        root.refuse("'balls' or 'fill'", "neither");
    }
    scene.settings.balls = static_cast<std::uint32_t>(scene.balls.size()) + (scene.fill ? scene.fill->count : 0u);
    return scene;
}

Scene load_scene(const std::filesystem::path& path) { return parse_scene(read_file(path), path.string()); }

}  // namespace ballpit
