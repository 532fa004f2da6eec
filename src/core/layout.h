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

static_assert(sizeof(Key) == 8 && sizeof(CellRange) == 8 && sizeof(Status) == 24 && sizeof(HashSum) == 8 &&
              sizeof(Compensation) == 24);

}  // namespace ballpit::layout

namespace ballpit {

using layout::CellRange;
using layout::Compensation;
using layout::Key;
using layout::Status;

inline bool operator==(const Key& a, const Key& b) { return a.cell_id == b.cell_id && a.ball_id == b.ball_id; }
inline bool operator==(const CellRange& a, const CellRange& b) { return a.first == b.first && a.end == b.end; }

/// The order of the sort: by cell id, ties by ball id, which makes the neighbour order reproducible.
inline bool operator<(const Key& a, const Key& b) {
    return a.cell_id != b.cell_id ? a.cell_id < b.cell_id : a.ball_id < b.ball_id;
}

}  // namespace ballpit
