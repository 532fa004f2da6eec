// Numbers that no device can have reached are told from those that one can.
#include "measure/device_limits.h"

#include <limits>

#include "support/catch.h"

using namespace ballpit;
using measure::DeviceLimits;

namespace {

// A large cache, and memory behind it.
DeviceLimits device() {
    DeviceLimits limits;
    limits.copies = {{1u << 20, 900.0}, {16u << 20, 5000.0}, {512u << 20, 2800.0}};
    limits.clock_step_ms = 32e-6;
    limits.least_span_ms = 1e-3;
    return limits;
}

constexpr std::size_t mebibyte = 1u << 20;

}  // namespace

TEST_CASE("the limit is what copies of that size or a larger one have reached", "[measure]") {
    const DeviceLimits limits = device();
    CHECK(measure::copy_limit(limits, 1000) == 5000.0);  // a small copy is slow for other reasons
    CHECK(measure::copy_limit(limits, 16 * mebibyte) == 5000.0);
    CHECK(measure::copy_limit(limits, 17 * mebibyte) == 2800.0);
    CHECK(measure::copy_limit(limits, 4096 * mebibyte) == 2800.0);
    CHECK(measure::copy_limit({}, 1) == 0.0);
}

TEST_CASE("faster than the device copies is impossible", "[measure]") {
    const DeviceLimits limits = device();
    const std::size_t bytes = 100 * mebibyte;
    const double at_the_limit = static_cast<double>(bytes) / (2800.0 * 1e6);
    CHECK(measure::gb_s(bytes, at_the_limit) == Approx(2800.0));
    CHECK(measure::impossible(at_the_limit, bytes, bytes, limits).empty());
    CHECK(measure::impossible(at_the_limit / 1.2, bytes, bytes, limits).empty());  // reading may beat copying
    const std::string why = measure::impossible(at_the_limit / 1.3, bytes, bytes, limits);
    CHECK(why.find("GB/s") != std::string::npos);
    CHECK(why.find("2.8e+03") != std::string::npos);
    // Many passes over what fits into the cache may be as fast as the cache.
    CHECK(measure::impossible(at_the_limit / 1.3, bytes, 8 * mebibyte, limits).empty());
    CHECK_FALSE(measure::impossible(at_the_limit / 3.0, bytes, 8 * mebibyte, limits).empty());
    // Without a limit nobody knows.
    DeviceLimits unknown = limits;
    unknown.copies.clear();
    CHECK(measure::impossible(0.002, bytes, bytes, unknown).empty());
}

TEST_CASE("what takes less time than the clock can tell is impossible", "[measure]") {
    DeviceLimits limits = device();
    CHECK(measure::impossible(0.0011, 64, 64, limits).empty());
    CHECK(measure::impossible(0.0009, 64, 64, limits).find("clock") != std::string::npos);
    CHECK_FALSE(measure::impossible(0.0, 0, 0, limits).empty());
    CHECK_FALSE(measure::impossible(-1.0, 0, 0, limits).empty());
    limits.least_span_ms = 0.0;  // two looks at the clock within one of its steps
    CHECK(measure::impossible(0.0009, 64, 64, limits).empty());
    CHECK_FALSE(measure::impossible(16e-6, 64, 64, limits).empty());
    CHECK(measure::gb_s(100, 0.0) == 0.0);
}

TEST_CASE("what the device's clock takes for longer than the run lasted is impossible", "[measure]") {
    const DeviceLimits limits = device();
    const std::vector<double> times = {30.0, 34.0, 36.0};  // ms
    CHECK(measure::impossible(times, 100.0, 64, 64, limits).empty());
    CHECK(measure::impossible(times, 98.5, 64, 64, limits).empty());  // two clocks
    const std::string why = measure::impossible(times, 90.0, 64, 64, limits);
    CHECK(why.find("100 ms by the device's clock") != std::string::npos);
    CHECK(why.find("90 ms") != std::string::npos);
    // Single times that are wrong do not show in the median.
    CHECK_FALSE(measure::impossible(std::vector{1.0, 1.0, 1.67e13}, 3000.0, 64, 64, limits).empty());
    CHECK_FALSE(measure::impossible(std::vector{1.0, std::numeric_limits<double>::quiet_NaN()}, 3000.0, 64, 64, limits)
                    .empty());
    // All else is asked as well.
    CHECK(measure::impossible(std::vector{1e-4}, 100.0, 64, 64, limits).find("clock can tell") != std::string::npos);
    CHECK_FALSE(measure::impossible(std::vector{0.01}, 100.0, 100 * mebibyte, 100 * mebibyte, limits).empty());
    CHECK_FALSE(measure::impossible(std::vector<double>{}, 100.0, 64, 64, limits).empty());  // all of them lost
}
