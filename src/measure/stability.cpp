#include "measure/stability.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

#include "core/contact.h"
#include "measure/float_spacing.h"

namespace ballpit::measure {

namespace {

std::string number(double value) {
    std::string text(32, '\0');
    text.resize(static_cast<std::size_t>(std::snprintf(text.data(), text.size(), "%.3g", value)));
    return text;
}

double substep(const Settings& settings) { return settings.dt / settings.substeps; }

bool has_spring(const Settings& settings) { return settings.laws.contact || settings.laws.walls; }

// A few per cent inside the limit, so that the gauge does not flicker on it.
constexpr double margin = 0.97;

// So many substeps would change a quantity that goes with dt by `factor`.
std::optional<Remedy> other_substeps(const Settings& settings, double factor) {
    const double wanted = std::ceil(settings.substeps / factor);
    const SettingInfo* row = find_setting("substeps");
    if (!std::isfinite(wanted) || wanted < row->minimum || wanted > row->maximum) {
        return std::nullopt;
    }
    return Remedy{"substeps", std::to_string(static_cast<std::uint32_t>(wanted))};
}

Gauge with_remedy(Gauge gauge, std::optional<Remedy> remedy) {
    if (gauge.light() != Light::green) {
        gauge.remedy = std::move(remedy);
    }
    return gauge;
}

// A gauge whose value is proportional to dt, or, where low is bad, to 1 / dt.
Gauge with_substeps(Gauge gauge, const Settings& settings) {
    const double factor = gauge.low_is_bad ? gauge.value / gauge.amber : gauge.amber / gauge.value;
    return with_remedy(std::move(gauge), other_substeps(settings, margin * factor));
}

Gauge stability(const MeterRecord& record, const Settings& settings) {
    const double omega = stiffest_mode(record.reading, settings);
    const bool touching = record.reading.max_stiffness > 0.0;
    Gauge gauge{"dt / dt_c", "", dt_over_critical(record, settings), 0.5, 0.9, false, "", std::nullopt};
    gauge.text = std::string(touching ? "The stiffest ball, held by all that it touches,"
                                      : "Nothing touches yet; a ball among twelve others") +
                 " oscillates at no more than " + number(omega) + " 1/s: beyond 1 a pile may blow up.";
    return with_substeps(std::move(gauge), settings);
}

Gauge substeps_per_contact(const MeterRecord& record, const Settings& settings) {
    const double balls = settings.laws.contact ? 2.0 : 1.0;  // k / m_eff = 2 k / m for two, k / m at a wall
    const double omega = std::sqrt(balls * settings.stiffness * record.reading.max_lightness);
    Gauge gauge{"substeps a contact", "", std::numbers::pi / (omega * substep(settings)), 10.0, 4.0, true, "",
                std::nullopt};
    gauge.text = "The shortest contact lasts " + number(1e3 * std::numbers::pi / omega) +
                 " ms. Leapfrog's restitution is off by at most 1.23 over the square of this number.";
    return with_substeps(std::move(gauge), settings);
}

Gauge travel(const MeterRecord& record, const Settings& settings) {
    Gauge gauge{"v dt / D", "", record.reading.max_speed_share * substep(settings), 0.25, 0.5, false, "", std::nullopt};
    gauge.text =
        "The share of its diameter that the fastest ball moves in a substep: beyond 1/2 two may miss each other.";
    return with_substeps(std::move(gauge), settings);
}

Gauge drag(const MeterRecord& record, const Settings& settings) {
    Gauge gauge{"drag dt", "", record.drag * substep(settings), 0.1, 1.0, false, "", std::nullopt};
    gauge.text = "The share of its speed that a ball loses in a substep. The factor is exact; what meets it is not.";
    return with_substeps(std::move(gauge), settings);
}

// Positions of floats stand in steps of one ulp: v dt rounds to those, which is an error of v of half an ulp over dt.
std::optional<Gauge> float_floor(const MeterRecord& record, const Settings& settings, double largest_radius,
                                 double largest_coordinate) {
    const MeterReading& reading = record.reading;
    const double mean_square = 2.0 * reading.kinetic / reading.mass;
    const double fall = 2.0 * glm::length(record.gravity) * 2.0 * largest_radius;
    const double speed = std::sqrt(std::max(mean_square, fall));
    if (!(speed > 0.0) || !(largest_coordinate > 0.0)) {
        return std::nullopt;
    }
    const double ulp = float_spacing(largest_coordinate);
    const double dt = substep(settings);
    Gauge gauge{"float floor", "", dt > 0.0 ? 0.5 * ulp / (dt * speed) : 0.0, 1e-3, 1e-2, false, "", std::nullopt};
    gauge.text = "Rounding of positions, " + number(ulp) + " m at the walls, against the way of a ball at " +
                 number(speed) + " m/s in a substep: more substeps make it worse.";
    const double fewer = std::floor(settings.substeps * margin * gauge.amber / gauge.value);
    return with_remedy(gauge, fewer >= 1.0
                                  ? std::optional(Remedy{"substeps", std::to_string(static_cast<std::uint32_t>(fewer))})
                                  : std::nullopt);
}

Gauge cells(const Grid& grid, double largest_radius) {
    Gauge gauge{"cell / 2 r", "", grid.cell_width / (2.0 * largest_radius), 1.0, 1.0, true, "", std::nullopt};
    gauge.text = "Cells narrower than the largest ball miss contacts.";
    return with_remedy(std::move(gauge), Remedy{"cell_factor", "1"});
}

// N s/m, of two of the lightest balls, or of one and a wall.
double lightest_dashpot(const MeterReading& reading, const Settings& settings) {
    const double restitution = settings.laws.restitution ? settings.restitution : 1.0;
    const double zeta = damping_ratio_from_restitution(restitution, settings.limit_force);
    const double mass = (settings.laws.contact ? 0.5 : 1.0) / reading.max_lightness;
    const double c = 2.0 * zeta * std::sqrt(settings.stiffness * mass);
    return settings.dashpot == DashpotMethod::semi_implicit
               ? c / (1.0 + semi_implicit_share * substep(settings) * c / mass)
               : c;
}

// These integrators act as a dashpot of their own that pushes: -k dt for forward Euler, half of it for the historical.
Gauge heating(const MeterRecord& record, const Settings& settings) {
    const bool historical = settings.integrator == Integrator::historical;
    const double c = lightest_dashpot(record.reading, settings);
    const double pushing = settings.stiffness * substep(settings) * (historical ? 0.5 : 1.0);
    Gauge gauge{historical ? "c - k dt / 2" : "c - k dt", "N s/m", c - pushing, 0.5 * c, 0.0, true, "", std::nullopt};
    gauge.text = "This integrator pushes balls apart like a dashpot of " + number(-pushing) +
                 " N s/m: what the contact has left of its own " + number(c) + " must be more than nothing.";
    return with_remedy(std::move(gauge), Remedy{"integrator", "leapfrog"});
}

}  // namespace

Light Gauge::light() const {
    const bool green = low_is_bad ? value >= amber && value > 0.0 : value < amber;  // not a number is red
    const bool short_of_red = low_is_bad ? value >= red && value > 0.0 : value < red;
    return green ? Light::green : short_of_red ? Light::amber : Light::red;
}

double critical_dt(double omega, double damping) {
    if (!(omega > 0.0)) {
        return std::numeric_limits<double>::infinity();
    }
    const double z = damping / (2.0 * omega);
    return 2.0 / omega * (std::sqrt(1.0 + z * z) - z);
}

double stiffest_mode(const MeterReading& reading, const Settings& settings) {
    if (reading.max_stiffness > 0.0) {
        return std::sqrt(reading.max_stiffness);
    }
    const double bound = settings.laws.contact ? 8.0 : 3.0;  // without other balls: the three walls of a corner
    return std::sqrt(bound * settings.stiffness * reading.max_lightness);
}

double dt_over_critical(const MeterRecord& record, const Settings& settings) {
    if (!has_spring(settings) || !(record.reading.mass > 0.0)) {
        return 0.0;
    }
    const MeterReading& reading = record.reading;
    const double omega = stiffest_mode(reading, settings);
    // Before anything touches: as if the dashpots of those neighbours were all of two such balls.
    const double damping = reading.max_stiffness > 0.0
                               ? reading.max_damping
                               : lightest_dashpot(reading, settings) * omega * omega / settings.stiffness;
    return substep(settings) / critical_dt(omega, damping);
}

std::vector<Gauge> gauges(const MeterRecord& record, const Settings& settings, const Grid& grid, double largest_radius,
                          double largest_coordinate) {
    std::vector<Gauge> list;
    if (!(record.reading.mass > 0.0)) {
        return list;
    }
    if (has_spring(settings)) {
        list.push_back(stability(record, settings));
        list.push_back(substeps_per_contact(record, settings));
        list.push_back(travel(record, settings));
    }
    if (settings.laws.drag) {
        list.push_back(drag(record, settings));
    }
    if (!settings.laws.compensated) {  // those have no such floor: what rounding leaves out is kept
        if (const auto floor = float_floor(record, settings, largest_radius, largest_coordinate)) {
            list.push_back(*floor);
        }
    }
    if (settings.laws.contact && settings.neighbours == NeighbourSearch::grid) {
        list.push_back(cells(grid, largest_radius));
    }
    const bool heats =
        settings.integrator == Integrator::historical || settings.integrator == Integrator::forward_euler;
    if (has_spring(settings) && heats) {
        list.push_back(heating(record, settings));
    }
    return list;
}

std::vector<Gauge> gauges(const MeterRecord& record, const Simulation& simulation) {
    const dvec3 half = simulation.half_extent();
    return gauges(record, simulation.settings(), simulation.schedule().grid, simulation.largest_ball_radius(),
                  std::max({half.x, half.y, half.z}));
}

}  // namespace ballpit::measure
