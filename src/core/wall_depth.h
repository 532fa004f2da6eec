// How deep a ball may be in a wall before the wall stops to push harder.
#pragma once

#include "core/box.h"
#include "core/features.h"
#include "core/settings.h"

namespace ballpit {

/// m: beyond this overlap a wall's spring keeps the force k * depth, so that a ball that got far outside comes back
/// without the speed of a spring that was never wound. It is a potential still: k depth (overlap - depth / 2). No less
/// than the largest diameter, with which a ball is outside as a whole, and no less than four times what holds up the
/// heaviest ball, and its share of all balls stacked on one wall, against gravity and the shaking.
double wall_depth(const Settings& settings, const Box& box, const Variety& variety);

/// J, of a spring k (N/m) that keeps its force beyond `depth` (m).
inline double capped_spring_energy(double k, double overlap, double depth) {
    const double held = overlap < depth ? overlap : depth;
    return k * held * (overlap - 0.5 * held);
}

}  // namespace ballpit
