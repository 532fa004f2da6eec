// Cost against the number of balls: what is measured, and the numbers behind the plot.
#include "measure/cost_curve.h"

#include <cmath>

#include "cpu/cpu_backend.h"
#include "support/catch.h"
#include "support/scenes.h"

using namespace ballpit;
using measure::CostPoint;

namespace {

measure::CostQuestion question(std::vector<std::uint32_t> counts) {
    const Scene scene = test::shipped_scene("bench_pile");
    return {scene, scene.settings, test::seed_of(scene), std::move(counts), {"bitonic", "bitonic_fused"}};
}

std::vector<CostPoint> power_law(double factor, double exponent) {
    std::vector<CostPoint> points;
    for (const std::uint32_t balls : {1024u, 4096u, 16384u, 65536u}) {
        points.push_back({"bitonic", balls, factor * std::pow(balls, exponent), {}});
    }
    return points;
}

}  // namespace

TEST_CASE("every sort is measured at every count", "[measure]") {
    measure::CostCurve curve(question({100, 400}), std::make_unique<cpu::CpuBackend<float>>());
    CHECK(curve.progress() == 0.0);
    std::size_t slices = 0;
    while (curve.advance(0.1)) {
        ++slices;
        CHECK(curve.progress() <= 1.0);
    }
    CHECK(slices > 4);
    CHECK(curve.done());
    CHECK(curve.progress() == 1.0);
    CHECK(curve.points().size() == 4);
    for (const char* sort : {"bitonic", "bitonic_fused"}) {
        const std::vector<CostPoint> points = curve.points(sort);
        REQUIRE(points.size() == 2);
        CHECK(points[0].balls == 100);
        CHECK(points[1].balls == 400);
        CHECK(points[1].ms > points[0].ms);
        CHECK(points[0].stage_ms[static_cast<std::size_t>(Stage::collide)] > 0.0);
    }
    CHECK_FALSE(curve.advance(1.0));
}

TEST_CASE("a sort that is too slow is spared larger counts", "[measure]") {
    measure::CostQuestion slow = question({100, 400});
    slow.limit_ms = 0.0;
    measure::CostCurve curve(slow, std::make_unique<cpu::CpuBackend<float>>());
    while (curve.advance(10.0)) {
    }
    REQUIRE(curve.points().size() == 2);
    CHECK(curve.points()[1].balls == 100);
}

TEST_CASE("counts go up in fours where a fill can give them", "[measure]") {
    CHECK(measure::cost_counts(test::shipped_scene("rain"), 20000) == std::vector<std::uint32_t>{1024, 4096, 16384});
    CHECK(measure::cost_counts(test::shipped_scene("rain"), 1000).empty());
    CHECK(measure::cost_counts(test::shipped_scene("two_balls"), 20000).empty());
    measure::CostCurve nothing(question({}), std::make_unique<cpu::CpuBackend<float>>());
    CHECK(nothing.done());
    CHECK(nothing.progress() == 1.0);
}

TEST_CASE("slope and cost between points are those of a power law", "[measure]") {
    const std::vector<CostPoint> points = power_law(1e-4, 1.3);
    CHECK(measure::slope(points).value() == Approx(1.3));
    CHECK(measure::cost_at(points, 2000.0).value() == Approx(1e-4 * std::pow(2000.0, 1.3)));
    CHECK(measure::cost_at(points, 65536.0).value() == Approx(points.back().ms));
    CHECK_FALSE(measure::cost_at(points, 1000.0));
    CHECK_FALSE(measure::cost_at(points, 65537.0));
    CHECK_FALSE(measure::slope(std::span(points).first(1)));
    // What small counts cost tells nothing of the slope of large ones.
    std::vector<CostPoint> flat_first = points;
    flat_first.front().ms *= 100.0;
    CHECK(measure::slope(flat_first).value() == Approx(1.3));
}
