// The mirror's assign_cells, and the cell of a point in float and in double.
#include "cpu/assign_cells.h"

#include "cpu/cpu_backend.h"
#include "support/catch.h"
#include "support/stage_contract.h"
#include "support/substep_setup.h"

using namespace ballpit;

TEST_CASE("every ball gets the cell that its centre lies in", "[mirror]") {
    cpu::CpuBackend<float> backend;
    test::assigns_cells(backend, test::interesting_counts(65537));
}

TEST_CASE("points on faces, outside and of no number have a cell", "[mirror]") {
    cpu::CpuBackend<float> backend;
    test::assigns_strange_points(backend);
}

TEST_CASE("balls all over the box are in many cells", "[mirror]") {
    // The trap: the grid's origin added instead of subtracted puts every ball into few cells.
    const BallState state = test::placed_balls(test::Placement::uniform, 1000);
    const auto setup = test::setup_for(state, test::contact_features(), SortMethod::bitonic);
    const auto params = narrowed<float>(setup.params);
    std::array<std::array<int, 2>, 3> halves{};
    for (const vec4& position : state.positions) {
        const uvec3 cell = cpu::cell_coordinates(params, vec3(position));
        for (int axis = 0; axis < 3; ++axis) {
            ++halves[static_cast<std::size_t>(axis)][cell[axis] < params.grid_cells[axis] / 2 ? 0 : 1];
        }
    }
    for (const auto& half : halves) {
        CHECK(half[0] > 400);
        CHECK(half[1] > 400);
    }
}

TEST_CASE("the reference in double assigns the same cells away from faces", "[mirror]") {
    const BallState state = test::placed_balls(test::Placement::uniform, 5000);
    const auto setup = test::setup_for(state, test::contact_features(), SortMethod::bitonic);
    for (const vec4& position : state.positions) {
        REQUIRE(cpu::cell_coordinates(narrowed<float>(setup.params), vec3(position)) ==
                cpu::cell_coordinates(setup.params, dvec3(position)));
    }
}
