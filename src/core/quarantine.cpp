#include "core/quarantine.h"

#include <algorithm>
#include <cmath>

namespace ballpit {

void quarantine(BallState& state, const Box& box, Status& status) {
    for (std::uint32_t i = 0; i < state.count(); ++i) {
        vec4& position = state.positions[i];
        vec4& velocity = state.velocities[i];
        if (in_quarantine(position) || (can_be_squared(vec3(position)) && can_be_squared(vec3(velocity)))) {
            continue;
        }
        position = vec4(last_place(vec3(position), vec3(box.lower)), -position.w);
        velocity = vec4(vec3(0.0f), velocity.w);
        if (i < state.compensations.size()) {
            state.compensations[i] = {};
        }
        status.bits |= STATUS_NOT_FINITE;
        ++status.not_finite;
        status.quarantined_ball = std::max(status.quarantined_ball, i + 1);
    }
}

void release(BallState& state) {
    for (vec4& position : state.positions) {
        position.w = std::abs(position.w);
    }
}

}  // namespace ballpit
