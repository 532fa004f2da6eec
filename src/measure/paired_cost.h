// What something costs, from pairs of times taken in turn with it and without it: whatever else the machine does
// changes slowly, meets both and falls out of their difference.
#pragma once

#include <span>

namespace ballpit::measure {

struct PairedCost {
    double ms = 0.0;  // median of the differences
    // ms from the median to the end of the interval below that is nearer to 0; to the farther end where it holds 0.
    double uncertainty = 0.0;
    double with_ms = 0.0;  // medians of the two
    double without_ms = 0.0;
    bool known = false;  // the interval does not hold 0: this is no accident
};

/// The interval reaches from the second smallest difference to the second largest. For nine pairs it holds the true
/// median in 96 % of all cases, whatever the distribution is: 1 - 2 (1 + 9) / 2^9 (David and Nagaraja, Order
/// Statistics, 7.1). `with` and `without`: ms, as many of both, at least four.
PairedCost paired_cost(std::span<const double> with, std::span<const double> without);

}  // namespace ballpit::measure
