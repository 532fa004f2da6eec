#include "core/scene_sections.h"

#include <algorithm>
#include <limits>

namespace ballpit {

namespace {

// Where a moment is resumed, motion may have led anywhere; these only keep the numbers sane.
constexpr double longest_time = 1e12;   // s
constexpr double largest_phase = 1e15;  // rad
constexpr std::uint64_t most_substeps_run = 1023;

const SettingInfo& setting(std::string_view key) { return *find_setting(key); }

dvec3 read_vector_setting(const JsonValue& value, std::string_view key) {
    const SettingInfo& info = setting(key);
    return value.vector_between(info.minimum, info.maximum, info.unit);
}

template <class Enum, std::size_t Count>
Enum read_choice(const JsonValue& value, const std::array<std::string_view, Count>& names) {
    const std::string name = value.string();
    const auto found = std::ranges::find(names, std::string_view(name));
    if (found == names.end()) {
        std::string list;
        for (const std::string_view known : names) {
            list += (list.empty() ? "" : ", ") + std::string(known);
        }
        value.refuse("one of " + list);
    }
    return static_cast<Enum>(found - names.begin());
}

// What contact says of every touch; walls say it themselves where there is no contact between balls.
void read_spring(const JsonValue& spring, Settings& settings) {
    spring.expect_object({"stiffness", "restitution", "limit_force", "dashpot"});
    settings.stiffness = read_setting(spring.required("stiffness"), "stiffness");
    settings.restitution = 1.0;
    if (const auto restitution = spring.optional("restitution")) {
        settings.laws.restitution = true;
        settings.restitution = read_setting(*restitution, "restitution");
    }
    if (const auto limit_force = spring.optional("limit_force")) {
        settings.limit_force = limit_force->boolean();
    }
    if (const auto dashpot = spring.optional("dashpot")) {
        settings.dashpot = read_choice<DashpotMethod>(*dashpot, dashpot_names);
    }
}

void read_walls(const JsonValue& walls, Settings& settings) {
    if (walls.is_object()) {
        if (settings.laws.contact) {
            walls.refuse("true or false, because 'contact' says how stiff the walls are");
        }
        settings.laws.walls = true;
        read_spring(walls, settings);
        return;
    }
    settings.laws.walls = walls.boolean();
    if (settings.laws.walls && !settings.laws.contact) {
        walls.refuse("a law 'contact', whose stiffness walls share, or their own as { \"stiffness\": N/m }", "neither");
    }
}

void read_shake(const JsonValue& shake, Settings& settings) {
    shake.expect_object({"amplitude", "frequency"});
    if (!settings.laws.walls) {
        shake.refuse("a law 'walls' beside 'shake'", "none");
    }
    settings.laws.shake = true;
    settings.shake_amplitude = read_vector_setting(shake.required("amplitude"), "shake_amplitude");
    settings.shake_frequency = read_setting(shake.required("frequency"), "shake_frequency");
}

std::uint32_t read_whole_setting(const JsonValue& value, std::string_view key) {
    const auto number = static_cast<std::uint32_t>(value.whole_number(std::numeric_limits<std::uint32_t>::max()));
    check_range(setting(key), number, value.place());
    return number;
}

dvec3 read_shift(const JsonValue& value) { return value.vector_between(-largest_length, largest_length, "m"); }

}  // namespace

double read_setting(const JsonValue& value, std::string_view key) {
    check_range(setting(key), value.number(), value.place());
    return value.number();
}

void read_box(const JsonValue& box, Scene& scene) {
    box.expect_object({"half_extent", "reference_count", "walls_low", "walls_high", "wall_speed"});
    scene.half_extent = box.required("half_extent").vector_between(smallest_length, largest_length, "m");
    if (const auto count = box.optional("reference_count")) {
        scene.reference_count = static_cast<std::uint32_t>(count->whole_number(maximum_balls));
    }
    if (const auto low = box.optional("walls_low")) {
        scene.settings.walls_low = read_vector_setting(*low, "walls_low");
    }
    if (const auto high = box.optional("walls_high")) {
        scene.settings.walls_high = read_vector_setting(*high, "walls_high");
    }
    if (const auto speed = box.optional("wall_speed")) {
        scene.settings.wall_speed = read_setting(*speed, "wall_speed");
    }
}

void read_laws(const JsonValue& laws, Scene& scene) {
    laws.expect_object({"gravity", "drag", "contact", "walls", "shake", "diagnostics", "compensated"});
    Settings& settings = scene.settings;
    if (const auto gravity = laws.optional("gravity")) {
        settings.laws.gravity = true;
        settings.gravity = read_vector_setting(*gravity, "gravity");
    }
    if (const auto drag = laws.optional("drag")) {
        settings.laws.drag = true;
        settings.drag = read_setting(*drag, "drag");
    }
    if (const auto contact = laws.optional("contact")) {
        settings.laws.contact = true;
        read_spring(*contact, settings);
    }
    if (const auto walls = laws.optional("walls")) {
        read_walls(*walls, settings);
    }
    if (const auto shake = laws.optional("shake")) {
        read_shake(*shake, settings);
    }
    if (const auto diagnostics = laws.optional("diagnostics")) {
        settings.laws.diagnostics = diagnostics->boolean();
    }
    if (const auto compensated = laws.optional("compensated")) {
        settings.laws.compensated = compensated->boolean();
    }
}

void read_time(const JsonValue& time, Scene& scene) {
    time.expect_object({"dt", "substeps", "integrator"});
    Settings& settings = scene.settings;
    if (const auto dt = time.optional("dt")) {
        settings.dt = read_setting(*dt, "dt");
    }
    if (const auto substeps = time.optional("substeps")) {
        settings.substeps = read_whole_setting(*substeps, "substeps");
    }
    if (const auto integrator = time.optional("integrator")) {
        settings.integrator = read_choice<Integrator>(*integrator, integrator_names);
    }
}

void read_compute(const JsonValue& compute, Scene& scene) {
    compute.expect_object({"sort", "cell_factor", "grid_reuse", "neighbours", "sorted_copies", "keep_order"});
    if (const auto sort = compute.optional("sort")) {
        scene.settings.sort = read_choice<SortMethod>(*sort, sort_names);
    }
    if (const auto cell_factor = compute.optional("cell_factor")) {
        scene.settings.cell_factor = read_setting(*cell_factor, "cell_factor");
    }
    if (const auto reuse = compute.optional("grid_reuse")) {
        scene.settings.grid_reuse = read_whole_setting(*reuse, "grid_reuse");
    }
    if (const auto neighbours = compute.optional("neighbours")) {
        scene.settings.neighbours = read_choice<NeighbourSearch>(*neighbours, neighbour_search_names);
    }
    if (const auto copies = compute.optional("sorted_copies")) {
        scene.settings.sorted_copies = copies->boolean();
    }
    if (const auto keep = compute.optional("keep_order")) {
        scene.settings.keep_order = keep->boolean();
    }
}

void read_resume(const JsonValue& value, Scene& scene) {
    value.expect_object(
        {"step", "substep", "time", "velocity_lag", "walls_low", "walls_high", "shake_offset", "shake_phase"});
    Resume& resume = scene.resume.emplace();
    if (const auto step = value.optional("step")) {
        resume.step = step->whole_number(std::numeric_limits<std::uint64_t>::max());
    }
    if (const auto substep = value.optional("substep")) {
        resume.substep = static_cast<std::uint32_t>(substep->whole_number(most_substeps_run));
    }
    if (const auto time = value.optional("time")) {
        resume.time = time->number_between(0.0, longest_time, "s");
    }
    if (const auto lag = value.optional("velocity_lag")) {
        resume.velocity_lag = lag->number_between(0.0, 1.0, "s");  // no longer than a step
    }
    if (const auto low = value.optional("walls_low")) {
        resume.walls.low = read_shift(*low);
    }
    if (const auto high = value.optional("walls_high")) {
        resume.walls.high = read_shift(*high);
    }
    if (const auto offset = value.optional("shake_offset")) {
        resume.walls.shake = read_shift(*offset);
    }
    if (const auto phase = value.optional("shake_phase")) {
        resume.walls.shake_phase = phase->number_between(-largest_phase, largest_phase, "rad");
    }
}

void read_bounds(const JsonValue& value, Scene& scene) {
    constexpr double largest_overlap = 1e3;  // diameters: deep in a wall is more than one
    value.expect_object({"speed", "overlap", "outside"});
    Bounds& bounds = scene.bounds.emplace();
    bounds.speed = value.required("speed").number_between(0.0, largest_speed, "m/s");
    if (const auto overlap = value.optional("overlap")) {
        bounds.overlap = overlap->number_between(0.0, largest_overlap, "");
    }
    if (const auto outside = value.optional("outside")) {
        bounds.outside = outside->number_between(0.0, largest_length, "m");
    }
}

}  // namespace ballpit
