// The mirror's sort, pass by pass: a permutation in ascending order, whatever comes in.
#include "cpu/bitonic_sort.h"

#include "cpu/cpu_backend.h"
#include "support/catch.h"
#include "support/stage_contract.h"

using namespace ballpit;

TEST_CASE("the pass-by-pass sort sorts every pattern at every size", "[mirror]") {
    cpu::CpuBackend<float> backend;
    test::sorts_every_pattern(backend, SortMethod::bitonic, test::interesting_counts(65537));
}

TEST_CASE("one pass exchanges pairs (i, i XOR j), ascending where bit k is 0", "[mirror]") {
    std::vector<Key> keys;
    for (std::uint32_t i = 0; i < 8; ++i) {
        keys.push_back({7 - i, i});
    }
    cpu::bitonic_sort(keys, 4, 2);
    const std::array<std::uint32_t, 8> expected = {5, 4, 7, 6, 3, 2, 1, 0};
    for (std::size_t i = 0; i < 8; ++i) {
        CHECK(keys[i].cell_id == expected[i]);
    }
}
