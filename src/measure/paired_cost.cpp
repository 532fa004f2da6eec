#include "measure/paired_cost.h"

#include <algorithm>
#include <cassert>
#include <vector>

#include "measure/statistics.h"

namespace ballpit::measure {

PairedCost paired_cost(std::span<const double> with, std::span<const double> without) {
    assert(with.size() == without.size() && with.size() >= 4);
    std::vector<double> differences;
    for (std::size_t i = 0; i < with.size(); ++i) {
        differences.push_back(with[i] - without[i]);
    }
    std::ranges::sort(differences);
    const double low = differences[1];
    const double high = differences[differences.size() - 2];
    PairedCost cost;
    cost.ms = median(differences);
    cost.known = low > 0.0 || high < 0.0;
    cost.uncertainty = low > 0.0    ? cost.ms - low
                       : high < 0.0 ? high - cost.ms
                                    : std::max(high - cost.ms, cost.ms - low);
    cost.with_ms = median({with.begin(), with.end()});
    cost.without_ms = median({without.begin(), without.end()});
    return cost;
}

}  // namespace ballpit::measure
