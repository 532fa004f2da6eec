#include "measure/device_limits.h"

#include <algorithm>
#include <numeric>
#include <sstream>

#include "measure/statistics.h"

namespace ballpit::measure {

double copy_limit(const DeviceLimits& limits, std::size_t bytes) {
    if (limits.copies.empty()) {
        return 0.0;
    }
    double best = 0.0;
    for (const CopyRate& copy : limits.copies) {
        best = copy.bytes >= bytes ? std::max(best, copy.gb_s) : best;
    }
    const auto largest = std::ranges::max_element(limits.copies, {}, &CopyRate::bytes);
    return best > 0.0 ? best : largest->gb_s;
}

double gb_s(std::size_t bytes, double ms) { return ms > 0.0 ? static_cast<double>(bytes) / (ms * 1e6) : 0.0; }

std::string impossible(double ms, std::size_t bytes, std::size_t at_once, const DeviceLimits& limits) {
    std::ostringstream why;
    why.precision(3);
    const double least = std::max(limits.clock_step_ms, limits.least_span_ms);
    if (!(ms > 0.0) || ms < least) {
        why << ms << " ms is less than the clock can tell (" << least << " ms)";
        return why.str();
    }
    const double limit = copy_limit(limits, at_once);
    if (limit > 0.0 && gb_s(bytes, ms) > faster_than_copying * limit) {
        why << gb_s(bytes, ms) << " GB/s is more than the device can move (it copies " << limit << " GB/s)";
    }
    return why.str();
}

std::string impossible(std::span<const double> times_ms, double wall_ms, std::size_t bytes, std::size_t at_once,
                       const DeviceLimits& limits) {
    const double sum = std::accumulate(times_ms.begin(), times_ms.end(), 0.0);
    if (!(sum <= clocks_differ * wall_ms + 1.0)) {
        std::ostringstream why;
        why.precision(3);
        why << sum << " ms by the device's clock is more than the " << wall_ms << " ms that the run took on the wall";
        return why.str();
    }
    return impossible(median({times_ms.begin(), times_ms.end()}), bytes, at_once, limits);
}

}  // namespace ballpit::measure
