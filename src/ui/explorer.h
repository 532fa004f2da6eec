// What the explorer shows: the choices that were measured, and where the running scene stands among them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "measure/sweep.h"

namespace ballpit::ui {

struct ExplorerState {
    std::span<const measure::SweepRow> rows;  // those that are whole
    std::size_t wanted = 0;                   // rows in all; 0 before the first sweep
    bool running = false;
    bool stale = false;  // another scene, or settings that a choice does not replace, since the sweep began
    double progress = 0.0;
    std::optional<double> seconds_left;
    double seconds = 0.0;             // simulated, of each run
    double dt = 0.0;                  // s, a step
    std::optional<double> horizon_s;  // up to where positions mean something
    double float_floor = 0.0;         // m
    std::string_view note;            // why positions are not compared; else empty
    measure::SweepMetric metric = measure::SweepMetric::energy;
    measure::SweepPoint here;      // the running scene's choice
    std::optional<double> budget;  // what the metric may be, where a budget is set
};

/// Axis label of a metric.
std::string_view metric_label(measure::SweepMetric metric);

/// "leapfrog, 16 substeps, compensated".
std::string point_text(const measure::SweepPoint& point);

/// "0.00123", or "–".
std::string value_text(const std::optional<double>& value);

/// Decades that hold these values and half a decade beside them, as exponents of ten. {-3, 0} without any above 0.
struct Decades {
    double low = -3.0;
    double high = 0.0;
    friend bool operator==(const Decades&, const Decades&) = default;
};
Decades decades_of(std::span<const double> values);

}  // namespace ballpit::ui
