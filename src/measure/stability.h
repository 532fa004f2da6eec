// How far a running scene is from the edge: gauges as data, each with its limits and the setting that turns it green.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/grid.h"
#include "core/meter.h"
#include "core/settings.h"
#include "core/simulation.h"

namespace ballpit::measure {

enum class Light { green, amber, red };

/// A setting as `--set` would take it.
struct Remedy {
    std::string key;
    std::string value;
};

struct Gauge {
    std::string_view name;  // short, unique
    std::string_view unit;  // "" where it is a ratio
    double value = 0.0;
    double amber = 0.0;  // from here on it is no longer green
    double red = 0.0;
    bool low_is_bad = false;       // where fewer is worse: amber and red are upper limits of theirs
    std::string text;              // one sentence on what it says
    std::optional<Remedy> remedy;  // where one setting helps, and only while it is not green

    Light light() const;
};

inline constexpr std::string_view light_names[] = {"green", "amber", "red"};

/// The largest stable substep (s) of leapfrog, symplectic Euler and velocity Verlet with springs K, dashpots C, and
/// masses M, where no direction has more than omega^2 (1/s^2) of M^-1 K and `damping` (1/s) of M^-1 C:
/// (2 / omega) (sqrt(1 + Z^2) - Z), Z = damping / (2 omega), which is c omega / (2 k) where every contact has the same
/// c and k. (With the dashpots' velocity half a substep late, the substep is that of M - dt C / 2 - dt^2 K / 4, which
/// must be positive.) Infinite where nothing oscillates.
double critical_dt(double omega, double damping);

/// An upper bound of the fastest mode of balls that touch (1/s): omega^2 <= largest over the balls of
/// MeterReading::max_stiffness, by (n (x_i - x_j))^2 <= 2 (n x_i)^2 + 2 (n x_j)^2.
/// Before there are contacts: sqrt(8 k / m) of the lightest ball, which twelve neighbours of a densest packing hold.
double stiffest_mode(const MeterReading& reading, const Settings& settings);

/// All that apply to these laws. Empty for a reading without balls.
std::vector<Gauge> gauges(const MeterRecord& record, const Settings& settings, const Grid& grid, double largest_radius,
                          double largest_coordinate);

/// Those of the simulation as it stands, by its last record.
std::vector<Gauge> gauges(const MeterRecord& record, const Simulation& simulation);

/// The gauge of dt / dt_c, what `dt_over_dt_c` of a trace has; 0 where nothing oscillates.
double dt_over_critical(const MeterRecord& record, const Settings& settings);

}  // namespace ballpit::measure
