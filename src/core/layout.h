// C++ face of glsl/shared/layout.h: the same structs, with GLSL's type names, in a namespace of their own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>

namespace ballpit::layout {

using uint = std::uint32_t;
using vec3 = glm::vec3;
using uvec3 = glm::uvec3;

#include "shared/layout.h"

static_assert(sizeof(Key) == 8 && sizeof(CellRange) == 8 && sizeof(Status) == 40 && sizeof(HashSum) == 8 &&
              sizeof(Compensation) == 24);

}  // namespace ballpit::layout

namespace ballpit {

using layout::CellRange;
using layout::Compensation;
using layout::Key;
using layout::Status;

inline bool operator==(const Key& a, const Key& b) { return a.cell_id == b.cell_id && a.ball_id == b.ball_id; }
inline bool operator==(const CellRange& a, const CellRange& b) { return a.first == b.first && a.end == b.end; }

/// What was seen in both.
inline Status sum_of(const Status& a, const Status& b) {
    return {a.bits | b.bits,
            a.not_finite + b.not_finite,
            a.out_of_bounds + b.out_of_bounds,
            a.over_capacity + b.over_capacity,
            a.missed + b.missed,
            a.drift_bits > b.drift_bits ? a.drift_bits : b.drift_bits,  // of floats that are not negative
            a.too_fast + b.too_fast,
            a.coincident + b.coincident,
            a.capped_walls + b.capped_walls,
            a.quarantined_ball > b.quarantined_ball ? a.quarantined_ball : b.quarantined_ball};
}

/// The order of the sort: by cell id, ties by ball id, which makes the neighbour order reproducible.
inline bool operator<(const Key& a, const Key& b) {
    return a.cell_id != b.cell_id ? a.cell_id < b.cell_id : a.ball_id < b.ball_id;
}

}  // namespace ballpit
