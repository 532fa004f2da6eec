#include "core/settings.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <vector>

#include "core/contact.h"
#include "core/error.h"

namespace ballpit {

namespace {

constexpr Feature always{};

constexpr std::array<SettingInfo, 12> table = {{
    {"balls", "Balls", "", 0, maximum_balls, true, always,
     "How many balls; those that stay keep their motion when the number changes.", &Settings::balls},
    {"gravity", "Gravity", "m/s^2", -100, 100, false, Feature::gravity, "Acceleration of every ball as x,y,z; z is up.",
     &Settings::gravity},
    {"drag", "Drag", "1/s", 0, 100, true, Feature::drag, "Linear drag: without forces the speed falls by exp(-drag t).",
     &Settings::drag},
    {"stiffness", "Stiffness", "N/m", 0, 1e8, true, Feature::contact,
     "Spring constant k of every contact: force per metre of overlap.", &Settings::stiffness},
    {"restitution", "Restitution", "", minimum_restitution, 1, false, Feature::dashpot,
     "Share of the approach speed that a collision gives back.", &Settings::restitution},
    {"limit_force", "No pull", "", 0, 1, false, Feature::dashpot,
     "Whether a contact may only push (on) or also pull while it opens (off).", &Settings::limit_force},
    {"dt", "Step length", "s", 0, 1, true, always,
     "Time from one displayed frame to the next; a substep is dt / substeps.", &Settings::dt},
    {"substeps", "Substeps", "", 1, 1024, true, always,
     "Runs of all stages in a step: more are slower and more accurate.", &Settings::substeps},
    {"integrator", "Integrator", "", 0, 0, false, always, "How velocity and position are advanced.",
     &Settings::integrator},
    {"sort", "Sort", "", 0, 0, false, Feature::contact,
     "How the keys are sorted: pass by pass, or with the inner passes fused in shared memory.", &Settings::sort},
    {"cell_factor", "Cell factor", "", 0.25, 8, true, Feature::contact,
     "Cell width over the largest diameter; below 1 the grid misses pairs, which is there to be shown.",
     &Settings::cell_factor},
    {"neighbours", "Neighbours", "", 0, 0, false, Feature::contact,
     "Whether a ball looks for its neighbours in the cells around it, or asks every other ball.",
     &Settings::neighbours},
}};

template <class Number>
bool parse_number(std::string_view text, Number& value) {
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    return error == std::errc{} && stop == end;
}

std::string number_text(double value) {
    std::array<char, 32> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), result.ptr};
}

std::string range_text(const SettingInfo& info) {
    return "from " + number_text(info.minimum) + " to " + number_text(info.maximum) +
           (info.unit.empty() ? "" : " " + std::string(info.unit));
}

[[noreturn]] void refuse(const SettingInfo& info, std::string_view text, const std::string& expected) {
    throw InputError("setting '" + std::string(info.key) + "' cannot be '" + std::string(text) + "': expected " +
                     expected);
}

template <class Enum>
void assign_choice(const SettingInfo& info, std::string_view text, Enum& value) {
    const auto names = setting_choices(info);
    const auto found = std::ranges::find(names, text);
    if (found == names.end()) {
        std::string list;
        for (const std::string_view name : names) {
            list += (list.empty() ? "" : ", ") + std::string(name);
        }
        refuse(info, text, "one of " + list);
    }
    value = static_cast<Enum>(found - names.begin());
}

// One assign() per type that a setting can have; std::visit picks.
struct Assign {
    const SettingInfo& info;
    std::string_view text;
    Settings& settings;

    double real(std::string_view part) const {
        double value = 0.0;
        if (!parse_number(part, value) || !std::isfinite(value) || value < info.minimum || value > info.maximum) {
            refuse(info, text, "a number " + range_text(info));
        }
        return value;
    }
    void operator()(double Settings::*member) const { settings.*member = real(text); }
    void operator()(std::uint32_t Settings::*member) const {
        std::uint32_t value = 0;
        if (!parse_number(text, value) || value < info.minimum || value > info.maximum) {
            refuse(info, text, "a whole number " + range_text(info));
        }
        settings.*member = value;
    }
    void operator()(bool Settings::*member) const {
        if (text != "true" && text != "false") {
            refuse(info, text, "true or false");
        }
        settings.*member = text == "true";
    }
    void operator()(dvec3 Settings::*member) const {
        const std::size_t first = text.find(',');
        const std::size_t second = first == std::string_view::npos ? first : text.find(',', first + 1);
        if (second == std::string_view::npos) {
            refuse(info, text, "three numbers x,y,z, each " + range_text(info));
        }
        settings.*member = {real(text.substr(0, first)), real(text.substr(first + 1, second - first - 1)),
                            real(text.substr(second + 1))};
    }
    void operator()(Integrator Settings::*member) const { assign_choice(info, text, settings.*member); }
    void operator()(SortMethod Settings::*member) const { assign_choice(info, text, settings.*member); }
    void operator()(NeighbourSearch Settings::*member) const { assign_choice(info, text, settings.*member); }
};

struct Text {
    const Settings& settings;

    std::string operator()(double Settings::*member) const { return number_text(settings.*member); }
    std::string operator()(std::uint32_t Settings::*member) const { return std::to_string(settings.*member); }
    std::string operator()(bool Settings::*member) const { return settings.*member ? "true" : "false"; }
    std::string operator()(dvec3 Settings::*member) const {
        const dvec3& v = settings.*member;
        return number_text(v.x) + "," + number_text(v.y) + "," + number_text(v.z);
    }
    std::string operator()(Integrator Settings::*member) const {
        return std::string(integrator_names.at(static_cast<std::size_t>(settings.*member)));
    }
    std::string operator()(SortMethod Settings::*member) const {
        return std::string(sort_names.at(static_cast<std::size_t>(settings.*member)));
    }
    std::string operator()(NeighbourSearch Settings::*member) const {
        return std::string(neighbour_search_names.at(static_cast<std::size_t>(settings.*member)));
    }
};

}  // namespace

std::span<const SettingInfo> setting_table() { return table; }

const SettingInfo* find_setting(std::string_view key) {
    const auto found = std::ranges::find(table, key, &SettingInfo::key);
    return found == table.end() ? nullptr : &*found;
}

std::span<const std::string_view> setting_choices(const SettingInfo& info) {
    if (std::holds_alternative<Integrator Settings::*>(info.member)) {
        return integrator_names;
    }
    if (std::holds_alternative<SortMethod Settings::*>(info.member)) {
        return sort_names;
    }
    if (std::holds_alternative<NeighbourSearch Settings::*>(info.member)) {
        return neighbour_search_names;
    }
    return {};
}

bool setting_applies(const SettingInfo& info, Features features) {
    return info.needs == always || features.has(info.needs);
}

std::string setting_text(const SettingInfo& info, const Settings& settings) {
    return std::visit(Text{settings}, info.member);
}

void assign_setting(Settings& settings, std::string_view key, std::string_view text) {
    const SettingInfo* info = find_setting(key);
    if (info == nullptr) {
        throw InputError("there is no setting '" + std::string(key) + "': `ballpit settings` lists them");
    }
    std::visit(Assign{*info, text, settings}, info->member);
}

void check_range(const SettingInfo& info, double value, std::string_view place) {
    if (!std::isfinite(value) || value < info.minimum || value > info.maximum) {
        throw InputError(std::string(place) + ": expected a number " + range_text(info) + ", found " +
                         number_text(value));
    }
}

}  // namespace ballpit
