// How finely floats can tell numbers apart.
#pragma once

#include <cmath>
#include <limits>

namespace ballpit::measure {

/// One ulp: from the float that is nearest to `value` up to the next one.
inline double float_spacing(double value) {
    const auto number = static_cast<float>(value);
    return static_cast<double>(std::nextafter(number, std::numeric_limits<float>::infinity()) - number);
}

}  // namespace ballpit::measure
