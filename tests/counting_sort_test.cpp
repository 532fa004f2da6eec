// The mirror's counting sort, and what it shares with the bitonic one: the grid of a table with more than one tile.
#include <algorithm>

#include "core/random.h"
#include "core/scene_schedule.h"
#include "cpu/bitonic_sort.h"
#include "cpu/bitonic_sort_strides.h"
#include "cpu/clear_cells.h"
#include "cpu/count_tiles.h"
#include "cpu/cpu_backend.h"
#include "cpu/scan_cells.h"
#include "measure/any_order.h"
#include "support/catch.h"
#include "support/counting_contract.h"
#include "support/scenes.h"
#include "support/stage_contract.h"

using namespace ballpit;

namespace {

bool same(const std::vector<Key>& a, const std::vector<Key>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Key& x, const Key& y) { return x == y; });
}

template <class T>
std::span<const std::byte> bytes_of(const std::vector<T>& elements) {
    return std::as_bytes(std::span(elements));
}

std::unique_ptr<Backend> mirror() { return std::make_unique<cpu::CpuBackend<float>>(); }

}  // namespace

TEST_CASE("the counting sort sorts every pattern at every size", "[mirror]") {
    cpu::CpuBackend<float> backend;
    test::counts_and_sorts_every_pattern(backend, test::interesting_counts(65537));
}

TEST_CASE("cells of tiles that are not marked are left alone, the last tile may be short", "[mirror]") {
    std::vector<CellRange> ranges(2 * TILE_CELLS + 3, CellRange{1, 2});
    std::vector<std::uint32_t> used = {1, 0, 1};
    cpu::clear_cells(ranges, used);
    CHECK((ranges.front() == CellRange{0, 0}));
    CHECK((ranges[TILE_CELLS - 1] == CellRange{0, 0}));
    CHECK((ranges[TILE_CELLS] == CellRange{1, 2}));
    CHECK((ranges[2 * TILE_CELLS - 1] == CellRange{1, 2}));
    CHECK((ranges.back() == CellRange{0, 0}));
    CHECK(used == std::vector<std::uint32_t>{0, 0, 0});
}

TEST_CASE("tiles are counted and cells are scanned", "[mirror]") {
    std::vector<CellRange> ranges(TILE_CELLS + 2, CellRange{0, 0});
    ranges[0].end = 2;
    ranges[TILE_CELLS - 1].end = 1;
    ranges[TILE_CELLS + 1].end = 3;
    std::vector<std::uint32_t> counts(2);
    cpu::count_tiles(ranges, counts);
    CHECK(counts == std::vector<std::uint32_t>{3, 3});
    cpu::scan_cells(ranges);
    CHECK((ranges[0] == CellRange{0, 2}));
    CHECK((ranges[1] == CellRange{0, 0}));
    CHECK((ranges[TILE_CELLS - 1] == CellRange{2, 3}));
    CHECK((ranges[TILE_CELLS + 1] == CellRange{3, 6}));
}

TEST_CASE("strides are the passes that they stand for", "[mirror]") {
    std::vector<Key> keys;
    for (std::uint32_t i = 0; i < 64; ++i) {
        keys.push_back({static_cast<std::uint32_t>(random_unit(1, 2, i) * 20.0), i});
    }
    std::vector<Key> passes = keys;
    cpu::bitonic_sort_strides(keys, 64, 32, 3);
    for (const std::uint32_t j : {32u, 16u, 8u}) {
        cpu::bitonic_sort(passes, 64, j);
    }
    CHECK(same(keys, passes));
}

TEST_CASE("tickets and scattered keys are compared in the mirror's order, and faults in them still show", "[measure]") {
    const std::vector<Key> keys = {{5, 0}, {2, 1}, {5, 2}, {5, 3}};
    const auto ordered = [&](const std::vector<std::uint32_t>& tickets) {
        return typed<std::uint32_t>(measure::tickets_in_order(bytes_of(tickets), keys));
    };
    CHECK(ordered({2, 0, 0, 1}) == std::vector<std::uint32_t>{0, 0, 1, 2});
    CHECK(ordered({1, 0, 1, 0}) == std::vector<std::uint32_t>{0, 0, 1, 1});  // one ticket twice
    const std::vector<CellRange> ranges = {{0, 0}, {0, 2}, {2, 3}};
    const auto scattered = [&](const std::vector<Key>& in) {
        return typed<Key>(measure::scattered_in_order(bytes_of(in), ranges));
    };
    CHECK((same(scattered({{1, 9}, {1, 4}, {2, 0}}), {{1, 4}, {1, 9}, {2, 0}})));
    CHECK((same(scattered({{2, 0}, {1, 4}, {1, 9}}), {{1, 4}, {2, 0}, {1, 9}})));
}

TEST_CASE("mirror: every sort, with copies and without, gives the same run in every scene", "[mirror]") {
    test::same_run_however_computed(mirror, 200, 20);
}

TEST_CASE("mirror: changed while it runs, sort and copies change no bit", "[mirror]") {
    test::changes_of_computing_change_nothing(mirror);
}

TEST_CASE("mirror: auto is one of the sorts, and counts nothing twice", "[mirror]") {
    test::automatic_sort_is_one_of_them(mirror);
}

TEST_CASE("whatever computes, no list asks for more than what every device has", "[core]") {
    Scene scene = test::shipped_scene("mixed_sizes");
    scene.settings.sort = SortMethod::counting;
    scene.settings.grid_reuse = 2;
    scene.settings.laws.diagnostics = true;
    const Schedule schedule = first_schedule(scene);
    std::vector<Dispatch> dispatches = schedule.dispatches;
    std::ranges::copy(there_and_back(schedule).dispatches, std::back_inserter(dispatches));
    for (const Dispatch& dispatch : dispatches) {
        CAPTURE(dispatch.name, dispatch.program.features.bits);
        std::vector<std::uint32_t> bindings;
        for (const auto* slots : {&dispatch.reads, &dispatch.writes}) {
            for (const Slot slot : *slots) {
                const std::uint32_t binding = binding_of(dispatch.program.shader, slot);
                CHECK((binding < 8 || slot == Slot::built_positions));  // a grid used again asks for more
                if (slots == &dispatch.reads || std::ranges::count(dispatch.reads, slot) == 0) {
                    CHECK(std::ranges::count(bindings, binding) == 0);  // two slots, one number
                    bindings.push_back(binding);
                }
            }
        }
    }
}
