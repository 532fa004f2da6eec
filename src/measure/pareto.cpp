#include "measure/pareto.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace ballpit::measure {

std::vector<std::size_t> pareto_front(std::span<const Trade> trades) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < trades.size(); ++i) {
        if (trades[i].error && std::isfinite(*trades[i].error)) {
            order.push_back(i);
        }
    }
    std::ranges::sort(order, {}, [&](std::size_t i) { return std::tuple(trades[i].cost, *trades[i].error, i); });
    std::vector<std::size_t> front;
    for (const std::size_t i : order) {
        if (front.empty() || *trades[i].error < *trades[front.back()].error) {
            front.push_back(i);
        }
    }
    return front;
}

}  // namespace ballpit::measure
