#include "core/contact.h"

#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

namespace ballpit {

namespace {

double limited_duration(double zeta) {
    if (zeta < 1.0) {
        const double s = std::sqrt(1.0 - zeta * zeta);
        return (std::numbers::pi - std::atan2(2.0 * zeta * s, 1.0 - 2.0 * zeta * zeta)) / s;
    }
    if (zeta == 1.0) {
        return 2.0;  // the common limit of both branches
    }
    const double s = std::sqrt(zeta * zeta - 1.0);
    return std::log((zeta + s) / (zeta - s)) / s;
}

double limited_restitution(double zeta) {
    if (zeta < 1.0) {
        const double s = std::sqrt(1.0 - zeta * zeta);
        return std::exp(-(zeta / s) * (std::numbers::pi - std::atan2(2.0 * zeta * s, 1.0 - 2.0 * zeta * zeta)));
    }
    return std::exp(-zeta * limited_duration(zeta));
}

double unlimited_restitution(double zeta) {
    if (zeta >= 1.0) {
        return 0.0;
    }
    return std::exp(-std::numbers::pi * zeta / std::sqrt(1.0 - zeta * zeta));
}

}  // namespace

double restitution_from_damping_ratio(double zeta, bool limit_force) {
    assert(zeta >= 0.0);
    return limit_force ? limited_restitution(zeta) : unlimited_restitution(zeta);
}

double contact_duration(double zeta, bool limit_force) {
    assert(zeta >= 0.0);
    if (limit_force) {
        return limited_duration(zeta);
    }
    return zeta < 1.0 ? std::numbers::pi / std::sqrt(1.0 - zeta * zeta) : std::numeric_limits<double>::infinity();
}

double largest_overlap(double zeta) {
    assert(zeta >= 0.0);
    if (zeta == 1.0) {
        return std::exp(-1.0);  // the common limit of both branches
    }
    const double s = std::sqrt(std::abs(1.0 - zeta * zeta));
    return std::exp(-(zeta / s) * (zeta < 1.0 ? std::acos(zeta) : std::atanh(s / zeta)));
}

double damping_ratio_from_restitution(double e, bool limit_force) {
    assert(e >= minimum_restitution);
    if (e >= 1.0) {
        return 0.0;
    }
    double low = 0.0;
    double high = 4.0;  // e = 0.014 when limited, 0 when not
    while (high - low > 1e-15 * high) {
        const double middle = 0.5 * (low + high);
        if (middle <= low || middle >= high) {
            break;  // neighbours in double: no number is left between them
        }
        (restitution_from_damping_ratio(middle, limit_force) > e ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

std::vector<float> damping_ratios_of(std::span<const double> restitutions, bool limit_force) {
    std::vector<float> ratios;
    ratios.reserve(restitutions.size());
    for (std::size_t i = 0; i < restitutions.size(); ++i) {
        // Most balls have the restitution of the ball before.
        ratios.push_back(i > 0 && restitutions[i] == restitutions[i - 1]
                             ? ratios.back()
                             : static_cast<float>(damping_ratio_from_restitution(restitutions[i], limit_force)));
    }
    return ratios;
}

}  // namespace ballpit
