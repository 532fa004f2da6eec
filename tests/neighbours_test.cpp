// Neighbour completeness (A25): the grid finds exactly the touching pairs of brute force.
#include <array>
#include <cmath>

#include "cpu/cpu_backend.h"
#include "measure/pairs.h"
#include "support/catch.h"
#include "support/stage_contract.h"
#include "support/substep_setup.h"

using namespace ballpit;

TEST_CASE("the grid finds the pairs of brute force", "[mirror]") {
    cpu::CpuBackend<float> backend;
    test::finds_every_pair(backend, std::array{0u, 1u, 2u, 63u, 64u, 65u, 127u, 1000u, 4097u});
}

TEST_CASE("both ways to find touching pairs agree", "[mirror]") {
    for (const test::Placement placement : test::placements) {
        for (const std::uint32_t count : {0u, 1u, 2u, 65u, 1000u}) {
            BallState state = test::placed_balls(placement, count);
            if (count > 10) {
                state.positions[5].x = std::numeric_limits<float>::quiet_NaN();
                state.positions[6].x = std::numeric_limits<float>::infinity();
                state.positions[7].z = -1e30f;
            }
            CHECK((measure::touching_pairs(state.positions) == measure::brute_force_pairs(state.positions)));
        }
    }
}

TEST_CASE("balls that barely touch across a face are found in every cell of a long row", "[mirror]") {
    // A pair almost one diameter apart, the first ball just below a face: rounding must not put a cell between them.
    const dvec3 half(64.0, 0.3, 0.3);
    for (const float radius : {0.1f, 0.15f, 0.123456f}) {
        const Grid grid = make_grid(half, static_cast<double>(radius), 1.0, 2);
        const auto below = [&](std::uint32_t face) {
            auto x = static_cast<float>(grid.origin.x + face * grid.cell_width);
            for (int step = 0; step < 3; ++step) {
                x = std::nextafter(x, -100.0f);
            }
            return x;
        };
        for (std::uint32_t face = 1; face + 1 < grid.cells.x; ++face) {
            for (const float fraction : {0.9999f, 0.99999f, 0.999999f, 0.9999999f}) {
                const float left = below(face);
                BallState state;
                state.positions = {vec4(left, 0, 0, radius), vec4(left + 2.0f * radius * fraction, 0, 0, radius)};
                state.velocities.assign(2, vec4(0, 0, 0, 1));
                if (!measure::touching(state.positions[0], state.positions[1])) {
                    continue;
                }
                const auto setup =
                    test::setup_for(state, test::contact_features(), SortMethod::bitonic, {}, grid, half);
                cpu::CpuBackend<float> backend;
                backend.load(state, setup.schedule, true);
                backend.run(setup.schedule, setup.params, 0, setup.schedule.dispatches.size());
                CAPTURE(radius, face, fraction);
                REQUIRE(read_slot<vec4>(backend, Slot::next_velocities)[0].x < 0.0f);
            }
        }
    }
}
