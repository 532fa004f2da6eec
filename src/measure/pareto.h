// Which choices nothing beats: none is both cheaper and more exact.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace ballpit::measure {

/// What something costs and how far it is off; without an error it takes no part.
struct Trade {
    double cost = 0.0;
    std::optional<double> error;
};

/// Indices of the Pareto front, by rising cost (so by falling error). Of equals the first counts.
std::vector<std::size_t> pareto_front(std::span<const Trade> trades);

}  // namespace ballpit::measure
