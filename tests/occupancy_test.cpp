// How full the cells are, and the order statistics that panels and reports show.
#include "measure/occupancy.h"

#include "measure/statistics.h"
#include "support/catch.h"

using namespace ballpit;

TEST_CASE("occupancy counts cells by their balls", "[measure]") {
    const std::vector<CellRange> ranges = {{0, 0}, {0, 3}, {3, 4}, {0, 0}, {4, 5}, {5, 8}};
    const auto occupancy = measure::occupancy_of(ranges);
    CHECK((occupancy.histogram == std::vector<std::uint32_t>{2, 2, 0, 2}));
    CHECK(occupancy.occupied == 4);
    CHECK(occupancy.max == 3);
    CHECK(occupancy.mean_occupied == 2.0);
}

TEST_CASE("what is fuller than the histogram is long shares its last bin", "[measure]") {
    const auto occupancy = measure::occupancy_of(std::vector<CellRange>{{0, 5}, {5, 105}}, 4);
    CHECK((occupancy.histogram == std::vector<std::uint32_t>{0, 0, 0, 2}));
    CHECK(occupancy.max == 100);
}

TEST_CASE("no cells and no balls are no division by zero", "[measure]") {
    CHECK(measure::occupancy_of({}).mean_occupied == 0.0);
    const auto empty = measure::occupancy_of(std::vector<CellRange>(10, CellRange{0, 0}));
    CHECK(empty.occupied == 0);
    CHECK(empty.mean_occupied == 0.0);
    CHECK((empty.histogram == std::vector<std::uint32_t>{10}));
}

TEST_CASE("quantiles are linear between neighbours", "[measure]") {
    CHECK(measure::median({}) == 0.0);
    CHECK(measure::median({3}) == 3.0);
    CHECK(measure::median({4, 1}) == 2.5);
    CHECK(measure::median({9, 1, 5}) == 5.0);
    CHECK(measure::quantile({0, 10}, 0.25) == 2.5);
    CHECK(measure::quantile({5, 1, 3}, 0.0) == 1.0);
    CHECK(measure::quantile({5, 1, 3}, 1.0) == 5.0);
}
