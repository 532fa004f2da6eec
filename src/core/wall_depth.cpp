#include "core/wall_depth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace ballpit {

double wall_depth(const Settings& settings, const Box& box, const Variety& variety) {
    const double diameter = 2.0 * variety.largest_radius;
    if (!(diameter > 0.0)) {
        return std::numeric_limits<double>::max();  // nobody said what balls there are
    }
    if (!(settings.stiffness > 0.0)) {
        return diameter;
    }
    constexpr double safety = 4.0;  // balls do not share their weight evenly, and bounce
    const double swing = 2.0 * std::numbers::pi * settings.shake_frequency;
    const dvec3 size = glm::max(box.size(), dvec3(diameter));
    double depth = diameter;
    for (int axis = 0; axis < 3; ++axis) {
        const double pull = (settings.laws.gravity ? std::abs(settings.gravity[axis]) : 0.0) +
                            (settings.laws.shake ? swing * swing * std::abs(settings.shake_amplitude[axis]) : 0.0);
        const double face = size[(axis + 1) % 3] * size[(axis + 2) % 3];
        const double stacked = std::min(1.0, diameter * diameter / face) * variety.total_mass;
        depth = std::max(depth, safety * pull * (variety.heaviest_mass + stacked) / settings.stiffness);
    }
    return depth;
}

}  // namespace ballpit
