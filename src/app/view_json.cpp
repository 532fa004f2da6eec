#include "app/view_json.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <span>
#include <string_view>
#include <type_traits>

#include "core/schedule.h"

namespace ballpit::app {

namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 4> look_names = {"auto", "model", "impostor", "simple"};
constexpr std::array<std::string_view, ui::ball_colours> colour_names = {"tinted", "plain",    "speed",  "cell",
                                                                         "slot",   "contacts", "radius", "difference"};

// The double that is written as shortly as the float.
double as_written(float value) {
    std::array<char, 32> text{};
    const auto written = std::to_chars(text.data(), text.data() + text.size(), value);
    double number = 0.0;
    std::from_chars(text.data(), written.ptr, number);
    return static_cast<float>(number) == value ? number : static_cast<double>(value);
}

// Two ways to go through the same list of fields, so that nothing can be written that is not read.
class Writer {
public:
    Writer(json& object) : object_(object) {}
    template <class T>
    void number(const char* key, const T& value, const T& usual, double, double) {
        if (value != usual) {
            if constexpr (std::is_same_v<T, float>) {
                object_[key] = as_written(value);
            } else {
                object_[key] = value;
            }
        }
    }
    void flag(const char* key, const bool& value, bool usual) {
        if (value != usual) {
            object_[key] = value;
        }
    }
    template <class T>
    void choice(const char* key, const T& value, T usual, std::span<const std::string_view> names) {
        if (value != usual) {
            object_[key] = names[static_cast<std::size_t>(value)];
        }
    }
    void colour(const char* key, const vec3& value, const vec3& usual) {
        if (value != usual) {
            object_[key] = {as_written(value.x), as_written(value.y), as_written(value.z)};
        }
    }

private:
    json& object_;
};

class Reader {
public:
    Reader(const JsonValue& object) : object_(object) { object.expect_object(); }
    template <class T>
    void number(const char* key, T& value, const T&, double low, double high) {
        if (const auto found = object_.optional(key)) {
            if constexpr (std::is_integral_v<T>) {
                value = static_cast<T>(found->whole_number(static_cast<std::uint64_t>(high)));
            } else {
                value = static_cast<T>(found->number_between(low, high, ""));
            }
        }
    }
    void flag(const char* key, bool& value, bool) {
        if (const auto found = object_.optional(key)) {
            value = found->boolean();
        }
    }
    template <class T>
    void choice(const char* key, T& value, T, std::span<const std::string_view> names) {
        if (const auto found = object_.optional(key)) {
            const auto name = std::ranges::find(names, found->string());
            if (name == names.end()) {
                found->refuse("one of the names that the window has");
            }
            value = static_cast<T>(name - names.begin());
        }
    }
    void colour(const char* key, vec3& value, const vec3&) {
        if (const auto found = object_.optional(key)) {
            value = vec3(found->vector_between(0.0, 1.0, ""));
        }
    }

private:
    const JsonValue& object_;
};

constexpr double most_slots = 1u << 23;
constexpr double most_cells = 1u << 24;

template <class Access, class View>
void view_fields(Access access, View& view) {
    const ui::ViewOptions usual;
    access.choice("look", view.look, usual.look, look_names);
    access.choice("colour", view.colour, usual.colour, colour_names);
    access.flag("box", view.box, usual.box);
    access.flag("ground", view.ground, usual.ground);
    access.flag("light", view.light, usual.light);
    access.flag("occupancy", view.occupancy, usual.occupancy);
    access.flag("timings", view.timings, usual.timings);
    access.flag("laws", view.laws, usual.laws);
    access.flag("meters", view.meters, usual.meters);
    access.flag("budget", view.budget, usual.budget);
    access.flag("explorer", view.explorer, usual.explorer);
    access.flag("costs", view.costs, usual.costs);
    access.flag("panels", view.panels, usual.panels);
    access.flag("stepper", view.stepper, usual.stepper);
    access.flag("microscope", view.microscope, usual.microscope);
    access.number("microscope_slots", view.microscope_options.slots, usual.microscope_options.slots, 0, most_slots);
    access.number("microscope_first", view.microscope_options.first, usual.microscope_options.first, 0, most_slots);
}

template <class Access, class Probe>
void probe_fields(Access access, Probe& probe) {
    const ui::ProbeOptions usual;
    access.flag("follow", probe.follow, usual.follow);
    access.flag("cells", probe.cells, usual.cells);
    access.flag("buffers", probe.buffers, usual.buffers);
    access.flag("split", probe.split, usual.split);
    access.flag("contacts", probe.contacts, usual.contacts);
    access.flag("arrows", probe.arrows, usual.arrows);
    access.number("arrow_seconds", probe.arrow_seconds, usual.arrow_seconds, 0.0, 100.0);
    access.flag("fade", probe.fade, usual.fade);
    access.flag("slice", probe.slice, usual.slice);
    access.number("slice_axis", probe.slice_axis, usual.slice_axis, 0, 2);
    access.number("slice_layer", probe.slice_layer, usual.slice_layer, 0, most_cells);
    access.flag("slice_cut", probe.slice_cut, usual.slice_cut);
    access.flag("click_picks_cell", probe.click_picks_cell, usual.click_picks_cell);
    access.choice("slot", probe.slot, usual.slot, slot_names);
    access.number("copies_a_second", probe.copies_a_second, usual.copies_a_second, ui::slowest_copies,
                  ui::fastest_copies);
}

template <class Access, class Light>
void light_fields(Access access, Light& light) {
    const ui::LightOptions usual;
    access.flag("orbiting", light.orbiting, usual.orbiting);
    access.number("angle", light.angle, usual.angle, -1000.0, 1000.0);
    access.number("distance", light.distance, usual.distance, 0.0, 1000.0);
    access.number("height", light.height, usual.height, -1000.0, 1000.0);
    access.number("speed", light.speed, usual.speed, -1000.0, 1000.0);
    access.colour("colour", light.colour, usual.colour);
    access.number("brightness", light.brightness, usual.brightness, 0.0, 1000.0);
    access.number("ambient", light.ambient, usual.ambient, 0.0, 1000.0);
}

}  // namespace

json shown_json(const Shown& shown) {
    json all = json::object();
    for (const char* part : {"view", "probe", "light"}) {
        all[part] = json::object();
    }
    view_fields(Writer(all["view"]), shown.view);
    probe_fields(Writer(all["probe"]), shown.probe);
    light_fields(Writer(all["light"]), shown.light);
    return all;
}

Shown read_shown(const JsonValue& value) {
    Shown shown;
    if (const auto view = value.optional("view")) {
        view_fields(Reader(*view), shown.view);
    }
    if (const auto probe = value.optional("probe")) {
        probe_fields(Reader(*probe), shown.probe);
    }
    if (const auto light = value.optional("light")) {
        light_fields(Reader(*light), shown.light);
    }
    return shown;
}

json camera_json(const view::Camera& camera) {
    json list = json::array();
    for (const float value :
         {camera.position.x, camera.position.y, camera.position.z, camera.yaw, camera.pitch, camera.field_of_view}) {
        list.push_back(as_written(value));
    }
    return list;
}

view::Camera read_camera(const JsonValue& value) {
    if (value.expect_array() != 6) {
        value.refuse("a list of six numbers");
    }
    const auto number = [&](std::size_t i, double low, double high) {
        return static_cast<float>(value.element(i).number_between(low, high, ""));
    };
    constexpr double farthest = 1e7;  // m
    constexpr double any_turn = 100.0;
    view::Camera camera;
    camera.position = {number(0, -farthest, farthest), number(1, -farthest, farthest), number(2, -farthest, farthest)};
    camera.yaw = number(3, -any_turn, any_turn);
    camera.pitch = number(4, -1.56, 1.56);  // maximum_pitch, rounded up
    camera.field_of_view = number(5, 0.05, 3.0);
    return camera;
}

}  // namespace ballpit::app
