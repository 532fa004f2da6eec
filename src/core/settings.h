// The values a user may change while a scene runs, and the table that describes them. The command line
// (`--set`, `ballpit settings`), the scene parser's ranges and the settings panel all read the one table.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "core/integrator.h"
#include "core/laws.h"
#include "core/vector.h"

namespace ballpit {

/// How the keys get into their order. `automatic`: whichever of the fused bitonic sort and the counting sort this
/// device does faster with so many balls, by a short measurement; the order, and with it every bit, is the same.
enum class SortMethod { bitonic, bitonic_fused, counting, automatic };
inline constexpr std::array<std::string_view, 4> sort_names = {"bitonic", "bitonic_fused", "counting", "auto"};

/// How collide finds the neighbours of a ball: in the cells around it, or by asking every other ball.
enum class NeighbourSearch { grid, brute_force };
inline constexpr std::array<std::string_view, 2> neighbour_search_names = {"grid", "brute_force"};

/// The dashpot of a contact: c as it is, or so much of it as a substep can follow (core/contact.h).
enum class DashpotMethod { explicit_, semi_implicit };  // NOLINT(readability-identifier-naming): a keyword
inline constexpr std::array<std::string_view, 2> dashpot_names = {"explicit", "semi_implicit"};

/// A hand that holds one ball: a critically damped spring to a point.
struct Pull {
    std::uint32_t ball = 0;
    dvec3 target{0.0};  // m
    friend bool operator==(const Pull&, const Pull&) = default;
};

struct Settings {
    std::uint32_t balls = 0;
    Laws laws;
    dvec3 gravity{0.0, 0.0, -9.8};
    double drag = 0.1;
    double stiffness = 1000.0;
    double restitution = 0.9;
    bool limit_force = true;
    DashpotMethod dashpot = DashpotMethod::explicit_;
    double dt = 1.0 / 60.0;
    std::uint32_t substeps = 8;
    Integrator integrator = Integrator::leapfrog;
    SortMethod sort = SortMethod::bitonic_fused;
    double cell_factor = 1.0;
    std::uint32_t grid_reuse = 1;
    NeighbourSearch neighbours = NeighbourSearch::grid;
    bool sorted_copies = true;
    bool keep_order = true;
    dvec3 walls_low{0.0};                  // m, where the lower walls shall stand, from where the scene has them
    dvec3 walls_high{0.0};                 // m, the same for the upper walls
    double wall_speed = 1.0;               // m/s, at which they go there
    dvec3 shake_amplitude{0.0, 0.0, 0.1};  // m
    double shake_frequency = 2.0;          // Hz
    std::optional<Pull> pull;

    friend bool operator==(const Settings&, const Settings&) = default;
};

inline constexpr std::uint32_t maximum_balls = 1u << 22;

using SettingMember = std::variant<double Settings::*, std::uint32_t Settings::*, bool Settings::*, dvec3 Settings::*,
                                   Integrator Settings::*, SortMethod Settings::*, NeighbourSearch Settings::*,
                                   DashpotMethod Settings::*, Laws Settings::*, std::optional<Pull> Settings::*>;

struct SettingInfo {
    std::string_view key;    // as in --set and in scene files
    std::string_view label;  // as on the panel
    std::string_view unit;   // "" where there is none
    double minimum;
    double maximum;
    bool logarithmic;                   // slider scale
    std::array<bool Laws::*, 2> needs;  // without any of these laws the setting does nothing; none: it always counts
    std::string_view about;             // one sentence
    SettingMember member;
};

/// Every setting, in the order of the panel.
std::span<const SettingInfo> setting_table();

/// The row with this key, or nullptr.
const SettingInfo* find_setting(std::string_view key);

/// Names a choice setting can take; empty for the other kinds.
std::span<const std::string_view> setting_choices(const SettingInfo& info);

/// Whether the setting does anything where these laws hold.
bool setting_applies(const SettingInfo& info, const Laws& laws);

/// Value as --set would take it, with round-trip precision: "8", "0.1", "0,0,-9.8", "leapfrog", "gravity,walls",
/// "73,0,0,5" (ball 73 is pulled to a point) or "none".
std::string setting_text(const SettingInfo& info, const Settings& settings);

/// Sets one value from text. Throws InputError (key, text, what was expected) for an unknown key, text that
/// does not parse, a value that is not finite or one outside the range.
void assign_setting(Settings& settings, std::string_view key, std::string_view text);

/// Throws InputError that begins with `place` if the value is not finite or outside the row's range.
void check_range(const SettingInfo& info, double value, std::string_view place);

}  // namespace ballpit
