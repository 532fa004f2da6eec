#include "ui/explorer.h"

#include <algorithm>
#include <cmath>

#include "ui/widgets.h"

namespace ballpit::ui {

std::string_view metric_label(measure::SweepMetric metric) {
    switch (metric) {
        case measure::SweepMetric::position:
            return "position error, m (rms, up to the horizon)";
        case measure::SweepMetric::energy:
            return "energy made or eaten, share of the start's a second";
        case measure::SweepMetric::overlap:
            return "largest overlap, diameters";
        case measure::SweepMetric::restitution:
            return "restitution error (95 % of collisions are below)";
    }
    return {};
}

std::string point_text(const measure::SweepPoint& point) {
    std::string words(integrator_names.at(static_cast<std::size_t>(point.integrator)));
    words += format(", %u %s", point.substeps, point.substeps == 1 ? "substep" : "substeps");
    if (point.compensated) {
        words += ", compensated";
    }
    if (point.grid_reuse > 1) {
        words += format(", one grid for %u substeps", point.grid_reuse);
    }
    return words;
}

std::string value_text(const std::optional<double>& value) { return value ? format("%.3g", *value) : "–"; }

Decades decades_of(std::span<const double> values) {
    constexpr double beside = 0.25;
    Decades decades;
    bool first = true;
    for (const double value : values) {
        if (!(value > 0.0) || !std::isfinite(value)) {
            continue;
        }
        const double exponent = std::log10(value);
        decades.low = first ? exponent : std::min(decades.low, exponent);
        decades.high = first ? exponent : std::max(decades.high, exponent);
        first = false;
    }
    return first ? decades : Decades{std::floor(decades.low - beside), std::ceil(decades.high + beside)};
}

}  // namespace ballpit::ui
