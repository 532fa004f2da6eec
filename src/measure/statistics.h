// Order statistics of a sample.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace ballpit::measure {

/// Quantile q in [0, 1], linear between neighbours (Hyndman and Fan 1996, type 7); 0 for an empty sample.
inline double quantile(std::vector<double> sample, double q) {
    if (sample.empty()) {
        return 0.0;
    }
    std::sort(sample.begin(), sample.end());
    const double place = q * static_cast<double>(sample.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sample.size() - 1);
    return std::lerp(sample[below], sample[above], place - static_cast<double>(below));
}

inline double median(std::vector<double> sample) { return quantile(std::move(sample), 0.5); }

}  // namespace ballpit::measure
