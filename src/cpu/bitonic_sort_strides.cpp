#include "cpu/bitonic_sort_strides.h"

#include "cpu/bitonic_sort.h"

namespace ballpit::cpu {

void bitonic_sort_strides(std::span<Key> keys, std::uint32_t k, std::uint32_t j, std::uint32_t passes) {
    for (std::uint32_t pass = 0; pass < passes; ++pass) {
        bitonic_sort(keys, k, j >> pass);
    }
}

}  // namespace ballpit::cpu
