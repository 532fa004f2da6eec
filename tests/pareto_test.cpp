// What nothing beats: neither cheaper nor more exact at once.
#include "measure/pareto.h"

#include <limits>

#include "support/catch.h"

using namespace ballpit;
using measure::pareto_front;
using measure::Trade;

namespace {

bool beats(const Trade& a, const Trade& b) {
    return a.cost <= b.cost && *a.error <= *b.error && (a.cost < b.cost || *a.error < *b.error);
}

}  // namespace

TEST_CASE("the front has what nothing beats, by rising cost", "[pareto]") {
    const std::vector<Trade> trades = {{4.0, 0.1}, {1.0, 1.0}, {2.0, 2.0}, {3.0, 0.5}, {3.0, 0.4}, {9.0, 0.1}};
    CHECK(pareto_front(trades) == std::vector<std::size_t>{1, 4, 0});
    const auto front = pareto_front(trades);
    for (std::size_t i = 0; i < trades.size(); ++i) {
        const bool beaten =
            std::any_of(trades.begin(), trades.end(), [&](const Trade& t) { return beats(t, trades[i]); });
        CHECK(beaten == (std::find(front.begin(), front.end(), i) == front.end()));
    }
}

TEST_CASE("what has no error takes no part in the front, and of equals the first counts", "[pareto]") {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    CHECK(pareto_front({}).empty());
    const std::vector<Trade> trades = {{1.0, std::nullopt}, {1.0, infinity}, {2.0, 0.5}, {2.0, 0.5}, {3.0, 0.0}};
    CHECK(pareto_front(trades) == std::vector<std::size_t>{2, 4});
}
