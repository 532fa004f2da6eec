#include "cpu/bitonic_sort.h"

#include <utility>

namespace ballpit::cpu {

void bitonic_sort(std::span<Key> keys, std::uint32_t k, std::uint32_t j) {
    for (std::uint32_t i = 0; i < keys.size(); ++i) {
        const std::uint32_t partner = i ^ j;
        if (partner < i) {
            continue;  // the pair was met at its lower slot
        }
        const bool ascending = (i & k) == 0;
        if ((keys[partner] < keys[i]) == ascending) {
            std::swap(keys[i], keys[partner]);
        }
    }
}

}  // namespace ballpit::cpu
