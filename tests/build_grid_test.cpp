// The mirror's clear_cells and build_grid: the ranges partition the slots, and nothing old is left.
#include "cpu/build_grid.h"

#include "cpu/clear_cells.h"
#include "cpu/cpu_backend.h"
#include "support/catch.h"
#include "support/stage_contract.h"

using namespace ballpit;

TEST_CASE("the ranges are those of counting, after every pattern", "[mirror]") {
    cpu::CpuBackend<float> backend;
    test::builds_the_grid(backend, test::interesting_counts(65537));
}

TEST_CASE("a key of no cell is counted, not written", "[mirror]") {
    cpu::CpuBackend<float> backend;
    test::refuses_keys_of_no_cell(backend);
}

TEST_CASE("one ball has a range of one slot", "[mirror]") {
    // The trap: `end` not written for a single ball.
    std::vector<CellRange> ranges(3, CellRange{9, 9});
    Status status{};
    std::vector<std::uint32_t> used = {1};
    cpu::clear_cells(ranges, used);
    CHECK(used.front() == 0);
    cpu::build_grid(std::vector<Key>{{1, 0}}, ranges, used, status);
    CHECK(used.front() == 1);
    CHECK((ranges[0] == CellRange{0, 0}));
    CHECK((ranges[1] == CellRange{0, 1}));
    CHECK((ranges[2] == CellRange{0, 0}));
    CHECK(status.bits == 0);
}
