// What collide looks at and what touches, counted without the stages.
#include "measure/crowding.h"

#include "core/random.h"
#include "measure/pairs.h"
#include "support/catch.h"

using namespace ballpit;

namespace {

Grid grid_of(double half, double radius, std::uint32_t balls) {
    return make_grid(Box(dvec3(half)), radius, 1.0, balls);
}

std::vector<vec4> scattered(std::uint32_t count, double half, float radius) {
    std::vector<vec4> balls;
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto at = [&](std::uint64_t axis) {
            return static_cast<float>(half * (2.0 * random_unit(7, axis, i) - 1.0));
        };
        balls.emplace_back(at(0), at(1), at(2), radius);
    }
    return balls;
}

bool near_each_other(const vec4& a, const vec4& b, const Grid& grid) {
    const auto cell = [&grid](const vec4& ball) {
        const dvec3 place = glm::floor((dvec3(ball) - grid.origin) / grid.cell_width);
        return glm::clamp(place, dvec3(0.0), dvec3(grid.cells) - 1.0);
    };
    const dvec3 apart = glm::abs(cell(a) - cell(b));
    return apart.x <= 1.0 && apart.y <= 1.0 && apart.z <= 1.0;
}

}  // namespace

TEST_CASE("candidates and contacts are those that asking every ball finds", "[measure]") {
    std::vector<vec4> balls = scattered(400, 1.0, 0.1f);
    balls.emplace_back(5.0f, -5.0f, 0.0f, 0.1f);  // outside: in the outermost cell
    const Grid grid = grid_of(1.0, 0.1, 400);
    double candidates = 0.0;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        for (std::size_t j = 0; j < balls.size(); ++j) {
            candidates += i != j && near_each_other(balls[i], balls[j], grid) ? 1.0 : 0.0;
        }
    }
    const measure::Crowding crowding = measure::crowding_of(balls, grid);
    const auto count = static_cast<double>(balls.size());
    CHECK(crowding.candidates == Approx(candidates / count));
    CHECK(crowding.contacts == Approx(2.0 * static_cast<double>(measure::touching_pairs(balls).size()) / count));
    CHECK(crowding.contacts > 0.5);
}

TEST_CASE("of many balls some speak for all", "[measure]") {
    const std::vector<vec4> balls = scattered(3000, 1.0, 0.1f);
    const Grid grid = grid_of(1.0, 0.1, 3000);
    const measure::Crowding all = measure::crowding_of(balls, grid);
    const measure::Crowding some = measure::crowding_of(balls, grid, 1000);
    CHECK(some.candidates == Approx(all.candidates).epsilon(0.05));
    CHECK(some.candidates != all.candidates);
    CHECK(measure::crowding_of({}, grid).candidates == 0.0);
}
