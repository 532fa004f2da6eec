// Slices of a long dispatch: who has to be cut, and whether every ball is in one slice, once.
#include "core/dispatch_slices.h"

#include "support/catch.h"
#include "support/substep_setup.h"

using namespace ballpit;

namespace {

void covers_each_ball_once(std::uint32_t balls, std::uint32_t count) {
    CAPTURE(balls, count);
    const std::vector<Slice> slices = slices_of(balls, count);
    CHECK(slices.size() <= std::max(count, (balls / GROUP_SIZE + 1) / widest_dispatch + 1));
    std::uint64_t next = 0;
    for (const Slice& slice : slices) {
        CHECK(slice.first == next);
        CHECK(slice.groups.y == 1);  // a folded one has threads beyond its end
        next = slice.first + std::uint64_t{slice.groups.x} * GROUP_SIZE;
    }
    CHECK(next >= balls);
    CHECK(next < balls + std::uint64_t{GROUP_SIZE});
}

Schedule contact_schedule(std::uint32_t balls, bool brute_force, const Grid& grid = test::dyadic_grid()) {
    Features features = test::contact_features();
    features.add(Feature::brute_force, brute_force);
    return make_schedule(balls, grid, features, SortMethod::bitonic_fused);
}

}  // namespace

TEST_CASE("slices cover each ball once", "[core]") {
    for (const std::uint32_t balls : {1u, 63u, 64u, 65u, 4097u, 1000000u}) {
        for (const std::uint32_t count : {1u, 2u, 3u, 64u, 5000u}) {
            covers_each_ball_once(balls, count);
        }
    }
    covers_each_ball_once(10000000, 1);  // more groups than one dispatch has: it would be folded
}

TEST_CASE("only dispatches that look at other balls are cut", "[core]") {
    std::vector<std::string> cut;
    Features features = test::contact_features();
    features.add(Feature::diagnostics);
    for (const Dispatch& dispatch :
         make_schedule(1000, test::dyadic_grid(), features, SortMethod::bitonic_fused, 4).dispatches) {
        if (looks_at_pairs(dispatch.program)) {
            cut.push_back(dispatch.name);
        }
    }
    CHECK(cut == std::vector<std::string>{"count_missed", "collide"});
    CHECK(looks_at_pairs({Shader::order_keys, {}}));
    CHECK_FALSE(looks_at_pairs({Shader::scatter_keys, {}}));
    CHECK_FALSE(looks_at_pairs({Shader::collide, {}}));
}

TEST_CASE("the density is that of the balls, not of the box", "[core]") {
    const Grid grid = test::dyadic_grid();
    const double volume = grid.cell_width * grid.cell_width * grid.cell_width;
    CHECK(local_density({}, grid) == 0.0);
    CHECK(local_density(std::vector(100, vec4(0.1f)), grid) == Approx(100.0 / volume));
    std::vector<vec4> spread;
    for (int i = 0; i < 16; ++i) {
        spread.emplace_back(-2.0f + 0.25f * static_cast<float>(i) + 0.1f, 0.1f, 0.1f, 0.1f);
    }
    CHECK(local_density(spread, grid) == Approx(1.0 / volume));
    // Outside, and nowhere at all.
    const float nan = std::numeric_limits<float>::quiet_NaN();
    CHECK(local_density(std::vector{vec4(-1e30f), vec4(nan), vec4(-2.0f), vec4(1e30f)}, grid) == Approx(2.5 / volume));
}

TEST_CASE("pairs are all with brute force, else those of the cells around", "[core]") {
    const std::uint32_t balls = 100000;
    const Grid grid = test::dyadic_grid();
    const double volume = grid.cell_width * grid.cell_width * grid.cell_width;
    CHECK(pairs_of(contact_schedule(balls, true), 0.0) == 1e10);
    CHECK(pairs_of(contact_schedule(balls, false), 2.0 / volume) == Approx(54.0 * balls));
    CHECK(pairs_of(contact_schedule(balls, false), balls / volume) == 1e10);  // all in one cell
    CHECK(pairs_of(contact_schedule(balls, false), 2.0 / volume, 1.0) == Approx(2.0 * balls));
    CHECK(cells_looked_at({Shader::order_keys, {}}) == 1.0);
    // Twice as wide cells, eight times as many balls.
    const Grid wide{grid.origin, 2.0 * grid.cell_width, uvec3(8)};
    CHECK(pairs_of(contact_schedule(balls, false, wide), 2.0 / volume) == Approx(8 * 54.0 * balls));
}
