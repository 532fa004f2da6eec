// The mirror's fused sort: tiles in one go.
#include "cpu/bitonic_sort_fused.h"

#include "core/random.h"
#include "cpu/bitonic_sort.h"
#include "cpu/cpu_backend.h"
#include "support/catch.h"
#include "support/stage_contract.h"

using namespace ballpit;

TEST_CASE("the fused sort sorts every pattern at every size", "[mirror]") {
    cpu::CpuBackend<float> backend;
    auto counts = test::interesting_counts(65537);
    counts.insert(counts.end(), {SORT_SMALL_TILE_SIZE * 3 - 1, SORT_SMALL_TILE_SIZE * 4 + 1, 131073});
    test::sorts_every_pattern(backend, SortMethod::bitonic_fused, counts);
}

TEST_CASE("a fused dispatch leaves what its passes leave", "[mirror]") {
    std::vector<Key> passes;
    for (std::uint32_t i = 0; i < 4 * SORT_TILE_SIZE; ++i) {
        passes.push_back({static_cast<std::uint32_t>(random_unit(1, 2, i) * 500.0), i});
    }
    std::vector<Key> fused = passes;
    for (std::uint32_t k = 2; k <= SORT_TILE_SIZE; k *= 2) {
        for (std::uint32_t j = k / 2; j > 0; j /= 2) {
            cpu::bitonic_sort(passes, k, j);
        }
    }
    cpu::bitonic_sort_fused(fused, SORT_TILE_SIZE, SORT_TILE_SIZE);
    CHECK(std::equal(passes.begin(), passes.end(), fused.begin(), [](const Key& a, const Key& b) { return a == b; }));
    for (std::uint32_t j = SORT_TILE_SIZE; j > 0; j /= 2) {
        cpu::bitonic_sort(passes, 2 * SORT_TILE_SIZE, j);
    }
    cpu::bitonic_sort(fused, 2 * SORT_TILE_SIZE, SORT_TILE_SIZE);
    cpu::bitonic_sort_fused(fused, 2 * SORT_TILE_SIZE, SORT_TILE_SIZE);
    CHECK(std::equal(passes.begin(), passes.end(), fused.begin(), [](const Key& a, const Key& b) { return a == b; }));
}
