// C++ face of glsl/shared/frame.h: the uniform block of the drawing shaders, and how a picture fills it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>

#include "view/picture.h"

namespace ballpit::view::layout {

using uint = std::uint32_t;
using glm::mat4;
using glm::uvec3;
using glm::vec2;
using glm::vec3;
using glm::vec4;

#include "shared/frame.h"

static_assert(offsetof(FrameParams, eye) == 64 && offsetof(FrameParams, grid_cells) == 160 &&
              offsetof(FrameParams, picture_size) == 208 && offsetof(FrameParams, sequential) == 288 &&
              sizeof(FrameParams) == 288 + 16 * (SEQUENTIAL_COLOURS + DIVERGING_COLOURS + CATEGORICAL_COLOURS));

}  // namespace ballpit::view::layout

namespace ballpit::view {

inline constexpr int shadow_map_size = 1024;  // pixels a side
inline constexpr GLuint unit_surface = 0;     // texture units
inline constexpr GLuint unit_shadow_map = 1;
inline constexpr GLuint unit_elements = 2;  // of a buffer, read by index

layout::FrameParams make_frame(const Picture& picture);

/// m between the lines of the ground: 1 m, or a round number that keeps a large or tiny box readable.
float ground_spacing(const Box& box);

}  // namespace ballpit::view
