#include "core/settings.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <vector>

#include "core/contact.h"
#include "core/error.h"
#include "core/text.h"

namespace ballpit {

namespace {

using Needs = std::array<bool Laws::*, 2>;
constexpr Needs always{};
constexpr Needs gravity{&Laws::gravity};
constexpr Needs drag{&Laws::drag};
constexpr Needs contact{&Laws::contact};
constexpr Needs restitution{&Laws::restitution};
constexpr Needs walls{&Laws::walls};
constexpr Needs shake{&Laws::shake};
constexpr Needs contact_or_walls{&Laws::contact, &Laws::walls};

constexpr std::array<SettingInfo, 23> table = {{
    {"balls", "Balls", "", 0, maximum_balls, true, always,
     "How many balls; those that stay keep their motion when the number changes.", &Settings::balls},
    {"gravity", "Gravity", "m/s^2", -100, 100, false, gravity, "Acceleration of every ball as x,y,z; z is up.",
     &Settings::gravity},
    {"drag", "Drag", "1/s", 0, 100, true, drag, "Linear drag: without forces the speed falls by exp(-drag t).",
     &Settings::drag},
    {"stiffness", "Stiffness", "N/m", 0, 1e8, true, contact_or_walls,
     "Spring constant k of every contact: force per metre of overlap.", &Settings::stiffness},
    {"restitution", "Restitution", "", minimum_restitution, 1, false, restitution,
     "Share of the approach speed that a collision gives back.", &Settings::restitution},
    {"limit_force", "No pull", "", 0, 1, false, restitution,
     "Whether a contact may only push (on) or also pull while it opens (off).", &Settings::limit_force},
    {"dashpot", "Dashpot", "", 0, 0, false, restitution,
     "Taken as it is, or only so much of it as a substep can follow: stable where it is strong, weaker for that.",
     &Settings::dashpot},
    {"dt", "Step length", "s", 0, 1, true, always,
     "Time from one displayed frame to the next; a substep is dt / substeps.", &Settings::dt},
    {"substeps", "Substeps", "", 1, 1024, true, always,
     "Runs of all stages in a step: more are slower and more accurate.", &Settings::substeps},
    {"integrator", "Integrator", "", 0, 0, false, always, "How velocity and position are advanced.",
     &Settings::integrator},
    {"sort", "Sort", "", 0, 0, false, contact,
     "How the keys are sorted: by bitonic passes, by those fused in shared memory, by counting, or as is fastest here.",
     &Settings::sort},
    {"cell_factor", "Cell factor", "", 0.25, 8, true, contact,
     "Cell width over the largest diameter; below 1 the grid misses pairs, which is there to be shown.",
     &Settings::cell_factor},
    {"grid_reuse", "Grid reuse", "", 1, 64, true, contact,
     "How many substeps use one grid; each step builds its own. Cells must be wider by the way that balls go "
     "meanwhile.",
     &Settings::grid_reuse},
    {"neighbours", "Neighbours", "", 0, 0, false, contact,
     "Whether a ball looks for its neighbours in the cells around it, or asks every other ball.",
     &Settings::neighbours},
    {"sorted_copies", "Copies", "", 0, 1, false, contact,
     "Whether collide reads the balls from copies in the order of the cells, or from where they are; same result.",
     &Settings::sorted_copies},
    {"keep_order", "Keep order", "", 0, 1, false, contact,
     "Whether, sorted by counting, balls stay in the order of the cells until somebody looks at them; same result.",
     &Settings::keep_order},
    {"laws", "Laws", "", 0, 0, false, always, "What the scene models, as a list of laws.", &Settings::laws},
    {"walls_low", "Lower walls", "m", -100, 100, false, walls,
     "Where the lower walls stand, counted from their place in the scene; they move there.", &Settings::walls_low},
    {"walls_high", "Upper walls", "m", -100, 100, false, walls,
     "Where the upper walls stand, counted from their place in the scene; they move there.", &Settings::walls_high},
    {"wall_speed", "Wall speed", "m/s", 0.001, 100, true, walls, "How fast walls move to where they are wanted.",
     &Settings::wall_speed},
    {"shake_amplitude", "Shake", "m", -10, 10, false, shake, "How far the box swings to either side.",
     &Settings::shake_amplitude},
    {"shake_frequency", "Frequency", "Hz", 0.01, 100, true, shake, "How often the box swings in a second.",
     &Settings::shake_frequency},
    {"pull", "Pull", "m", -1e4, 1e4, false, always,
     "A ball that is held, and the point to which a spring pulls it: id,x,y,z.", &Settings::pull},
}};

template <class Number>
bool parse_number(std::string_view text, Number& value) {
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    return error == std::errc{} && stop == end;
}

std::string range_of(const SettingInfo& info, std::string_view kind = "a number") {
    return range_text(info.minimum, info.maximum, info.unit, kind);
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
        refuse(info, text, "one of " + joined(names));
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
            refuse(info, text, range_of(info));
        }
        return value;
    }
    void operator()(double Settings::*member) const { settings.*member = real(text); }
    void operator()(std::uint32_t Settings::*member) const {
        std::uint32_t value = 0;
        if (!parse_number(text, value) || value < info.minimum || value > info.maximum) {
            refuse(info, text, range_of(info, "a whole number"));
        }
        settings.*member = value;
    }
    void operator()(bool Settings::*member) const {
        if (text != "true" && text != "false") {
            refuse(info, text, "true or false");
        }
        settings.*member = text == "true";
    }
    dvec3 vector(std::string_view part) const {
        const std::size_t first = part.find(',');
        const std::size_t second = first == std::string_view::npos ? first : part.find(',', first + 1);
        if (second == std::string_view::npos) {
            refuse(info, text, range_of(info, "three numbers x,y,z, each"));
        }
        return {real(part.substr(0, first)), real(part.substr(first + 1, second - first - 1)),
                real(part.substr(second + 1))};
    }
    void operator()(dvec3 Settings::*member) const { settings.*member = vector(text); }
    void operator()(Integrator Settings::*member) const { assign_choice(info, text, settings.*member); }
    void operator()(SortMethod Settings::*member) const { assign_choice(info, text, settings.*member); }
    void operator()(NeighbourSearch Settings::*member) const { assign_choice(info, text, settings.*member); }
    void operator()(DashpotMethod Settings::*member) const { assign_choice(info, text, settings.*member); }
    void operator()(Laws Settings::*member) const { settings.*member = parse_laws(text); }
    void operator()(std::optional<Pull> Settings::*member) const {
        if (text == "none") {
            (settings.*member).reset();
            return;
        }
        const std::size_t comma = text.find(',');
        Pull pull;
        if (comma == std::string_view::npos || !parse_number(text.substr(0, comma), pull.ball)) {
            refuse(info, text, "none, or the number of a ball and a point: id,x,y,z");
        }
        pull.target = vector(text.substr(comma + 1));
        settings.*member = pull;
    }
};

struct Text {
    const Settings& settings;

    std::string operator()(double Settings::*member) const { return shortest_text(settings.*member); }
    std::string operator()(std::uint32_t Settings::*member) const { return std::to_string(settings.*member); }
    std::string operator()(bool Settings::*member) const { return settings.*member ? "true" : "false"; }
    static std::string vector(const dvec3& v) {
        return shortest_text(v.x) + "," + shortest_text(v.y) + "," + shortest_text(v.z);
    }
    std::string operator()(dvec3 Settings::*member) const { return vector(settings.*member); }
    std::string operator()(Integrator Settings::*member) const {
        return std::string(integrator_names.at(static_cast<std::size_t>(settings.*member)));
    }
    std::string operator()(SortMethod Settings::*member) const {
        return std::string(sort_names.at(static_cast<std::size_t>(settings.*member)));
    }
    std::string operator()(NeighbourSearch Settings::*member) const {
        return std::string(neighbour_search_names.at(static_cast<std::size_t>(settings.*member)));
    }
    std::string operator()(DashpotMethod Settings::*member) const {
        return std::string(dashpot_names.at(static_cast<std::size_t>(settings.*member)));
    }
    std::string operator()(Laws Settings::*member) const { return laws_text(settings.*member); }
    std::string operator()(std::optional<Pull> Settings::*member) const {
        const std::optional<Pull>& pull = settings.*member;
        return pull ? std::to_string(pull->ball) + "," + vector(pull->target) : "none";
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
    if (std::holds_alternative<DashpotMethod Settings::*>(info.member)) {
        return dashpot_names;
    }
    return {};
}

bool setting_applies(const SettingInfo& info, const Laws& laws) {
    return info.needs == always ||
           std::ranges::any_of(info.needs, [&](bool Laws::*law) { return law != nullptr && laws.*law; });
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
        throw InputError(std::string(place) + ": expected " + range_of(info) + ", found " + shortest_text(value));
    }
}

}  // namespace ballpit
