// A ball whose position or velocity is no number, or too large to be squared, goes into quarantine: it stays where it
// was last, at rest, and touches nobody. Its radius is negative from then on, which costs nobody a byte: positions are
// read with their radius. Only where the law `diagnostics` holds; without it nobody looks.
#pragma once

#include <limits>
#include <span>

#include "core/ball_state.h"
#include "core/box.h"
#include "core/vector.h"

namespace ballpit {

/// Energies and distances are squares: what is beyond them in single is as good as infinite. False for NaN, too. In
/// the shader's order of additions.
template <class Real>
bool can_be_squared(const Vec3<Real>& v) {
    const Real size = v.x * v.x + v.y * v.y + v.z * v.z;
    return size <= static_cast<Real>(std::numeric_limits<float>::max());
}

template <class Real>
bool in_quarantine(const Vec4<Real>& position) {
    return position.w < 0;
}

/// Whether some ball goes into quarantine between these two states of the same balls: what it had of momentum is gone.
inline bool any_enters_quarantine(std::span<const vec4> before, std::span<const vec4> after) {
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (!in_quarantine(before[i]) && in_quarantine(after[i])) {
            return true;
        }
    }
    return false;
}

/// Along each axis where the ball was, or else in the corner.
template <class Real>
Vec3<Real> last_place(const Vec3<Real>& x, const Vec3<Real>& corner) {
    Vec3<Real> place = corner;
    for (int axis = 0; axis < 3; ++axis) {
        if (can_be_squared(Vec3<Real>(x[axis]))) {
            place[axis] = x[axis];
        }
    }
    return place;
}

/// What collide would do in the next substep, for balls that a backend is to be loaded with; counted in `status`.
void quarantine(BallState& state, const Box& box, Status& status);

/// Nobody is held any more: who was comes back where he is, at rest.
void release(BallState& state);

}  // namespace ballpit
