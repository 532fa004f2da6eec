// The uniform grid: it covers the box, its cells are wide enough, its table has a limit.
#include "core/grid.h"

#include <array>
#include <limits>

#include "support/catch.h"

using namespace ballpit;

TEST_CASE("the cells cover the box and are as wide as the largest diameter", "[core]") {
    for (const dvec3& half : {dvec3(1, 1, 1), dvec3(4, 4, 6), dvec3(10, 0.05, 3)}) {
        for (const double radius : {0.05, 0.1, 0.2, 0.7}) {
            const Grid grid = make_grid(half, radius, 1.0, 5000);
            CAPTURE(half.x, half.y, half.z, radius);
            CHECK(grid.cell_width >= 2.0 * radius);
            for (int axis = 0; axis < 3; ++axis) {
                CHECK(grid.origin[axis] == -half[axis]);  // the trap: added instead of subtracted
                CHECK(grid.cells[axis] * grid.cell_width >= 2.0 * half[axis]);
                CHECK((grid.cells[axis] - 1) * grid.cell_width < 2.0 * half[axis]);
            }
            CHECK(grid.cell_count() == grid.cells.x * grid.cells.y * grid.cells.z);
        }
    }
}

TEST_CASE("the cell factor scales the cells, also below one diameter", "[core]") {
    // And a little more against rounding, the more the farther the wall.
    CHECK(make_grid(dvec3(2.0), 0.1, 1.0, 1000).cell_width == Approx(0.2).epsilon(2e-5));
    CHECK(make_grid(dvec3(2.0), 0.1, 2.0, 1000).cell_width == Approx(0.4).epsilon(2e-5));
    CHECK(make_grid(dvec3(2.0), 0.1, 0.5, 100000).cell_width == Approx(0.1).epsilon(5e-5));
    CHECK(make_grid(dvec3(2.0), 0.1, 1.0, 1000).cell_width > 0.2);
}

TEST_CASE("a box of very many cells gets wider ones, never more than the table has", "[core]") {
    for (const std::uint32_t balls : {0u, 1u, 5000u, 1000000u, 4194304u}) {
        const Grid grid = make_grid(dvec3(1e4), 1e-4, 0.25, balls);
        CAPTURE(balls, grid.cell_width);
        CHECK(grid.cell_count() <= maximum_cells(balls));
        CHECK(static_cast<std::uint64_t>(grid.cells.x) * grid.cells.y * grid.cells.z <= maximum_cells(balls));
        CHECK(grid.cell_width >= 2e-4 * 0.25);
    }
    CHECK(maximum_cells(0) > 0);
    CHECK(maximum_cells(4194304) <= 1u << 26);
}

TEST_CASE("no balls and no size still make a grid", "[core]") {
    const Grid grid = make_grid(dvec3(1.0), 0.0, 1.0, 0);
    CHECK(grid.cell_width > 0.0);
    CHECK(grid.cell_count() >= 1);
    CHECK(make_grid(dvec3(0.1), 5.0, 1.0, 10).cell_count() == 1);  // a ball larger than the box
}

TEST_CASE("a point lies in one cell, in the nearest one where it lies outside or nowhere", "[core]") {
    const Grid grid{dvec3(-1.0, -2.0, -3.0), 0.5, uvec3(4, 8, 12)};
    CHECK(cell_of(dvec3(-1.0, -2.0, -3.0), grid) == uvec3(0));
    CHECK(cell_of(dvec3(-0.51, -1.49, 2.99), grid) == uvec3(0, 1, 11));
    CHECK(cell_of(dvec3(0.0, 0.0, 0.0), grid) == uvec3(2, 4, 6));
    CHECK(cell_of(dvec3(1e30, -1e30, 3.0), grid) == uvec3(3, 0, 11));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    CHECK(cell_of(dvec3(nan, infinity, -infinity), grid) == uvec3(0, 7, 0));
    CHECK(cell_id(uvec3(0), grid) == 0);
    CHECK(cell_id(uvec3(1, 0, 0), grid) == 1);
    CHECK(cell_id(uvec3(3, 7, 11), grid) == grid.cell_count() - 1);
    CHECK(cell_id(uvec3(2, 4, 6), grid) == (6 * 8 + 4) * 4 + 2);
}
