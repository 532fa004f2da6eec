#include "core/scene.h"

#include <cmath>

namespace ballpit {

double widening(const Scene& scene, std::uint32_t balls) {
    if (scene.reference_count == 0 || balls <= scene.reference_count) {
        return 1.0;
    }
    return std::sqrt(static_cast<double>(balls) / scene.reference_count);
}

}  // namespace ballpit
