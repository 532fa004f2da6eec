// What a device was measured to do at best, and which results that rules out. A stage cannot move bytes faster than
// the device copies them, nor take less time than the clock can tell: such a number is a mistake of the measurement.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace ballpit::measure {

struct CopyRate {
    std::size_t bytes = 0;  // read and written by one copy
    double gb_s = 0.0;      // 1e9 bytes a second, both counted
};

struct DeviceLimits {
    std::vector<CopyRate> copies;
    double clock_step_ms = 0.0;  // smallest step of the clock
    double least_span_ms = 0.0;  // what it measures where nothing happens, at the least
};

/// Reading alone may be faster than copying; by more than this it is not.
inline constexpr double faster_than_copying = 1.25;

/// GB/s, the highest of the copies that moved at least so many bytes: smaller ones have caches that these do not fit
/// in. Of the largest copy where none moved so many; 0 where none was measured.
double copy_limit(const DeviceLimits& limits, std::size_t bytes);

/// How fast so many bytes in so many ms are; 0 where no time has passed.
double gb_s(std::size_t bytes, double ms);

/// Why a time cannot be true for something that moves at least `bytes`, of which `at_once` in its largest part; empty
/// where it can.
std::string impossible(double ms, std::size_t bytes, std::size_t at_once, const DeviceLimits& limits);

/// The same of the median of some times of one run, no two of which overlap, while the wall's clock saw that run take
/// `wall_ms` in all.
std::string impossible(std::span<const double> times_ms, double wall_ms, std::size_t bytes, std::size_t at_once,
                       const DeviceLimits& limits);

/// What two clocks may differ by, beside a thousandth of a second.
inline constexpr double clocks_differ = 1.01;

}  // namespace ballpit::measure
