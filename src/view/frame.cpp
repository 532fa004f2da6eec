#include "view/frame.h"

#include <algorithm>
#include <cmath>

#include "view/palette.h"

namespace ballpit::view {

namespace {

static_assert(static_cast<unsigned>(BallColour::tinted) == COLOUR_TINTED &&
              static_cast<unsigned>(BallColour::plain) == COLOUR_PLAIN &&
              static_cast<unsigned>(BallColour::speed) == COLOUR_SPEED &&
              static_cast<unsigned>(BallColour::cell) == COLOUR_CELL);
static_assert(std::tuple_size_v<decltype(sequential_palette)> == SEQUENTIAL_COLOURS &&
              std::tuple_size_v<decltype(categorical_palette)> == CATEGORICAL_COLOURS);

void fill_camera(layout::FrameParams& frame, const Picture& picture) {
    const Camera& camera = picture.camera;
    const auto width = static_cast<float>(picture.width);
    const auto height = static_cast<float>(picture.height);
    frame.view_projection = projection(camera, picture.half_extent, width / height) * view_matrix(camera);
    frame.eye = camera.position;
    frame.pixels_per_radian = 0.5f * height / std::tan(0.5f * camera.field_of_view);
    frame.camera_right = right(camera);
    frame.camera_up = up(camera);
    frame.picture_size = {width, height};
}

void fill_light(layout::FrameParams& frame, const Picture& picture) {
    const Light& light = picture.light;
    frame.light_position = position(light, picture.half_extent);
    frame.light_colour = light.intensity * linear_from_srgb(light.colour);
    frame.light_distance = std::max(glm::length(frame.light_position), 1e-6f);
    frame.ambient = light.ambient;
    // Where the largest balls are smaller than a pixel of the shadow map, shadows would be noise.
    const bool fine_enough =
        0.25f * static_cast<float>(shadow_map_size * picture.grid.cell_width) > frame.light_distance;
    const bool shadows = picture.show_shadows && fine_enough;
    frame.shadow_range = shadows ? frame.light_distance + glm::length(picture.half_extent) : 0.0f;
    frame.marker_radius = 0.045f * glm::length(picture.half_extent);
}

}  // namespace

float ground_spacing(const vec3& half_extent) {
    constexpr float most_lines = 60.0f;
    constexpr float fewest_lines = 3.0f;
    const float width = 2.0f * std::max(half_extent.x, half_extent.y);
    float spacing = 1.0f;
    while (width / spacing > most_lines) {
        spacing *= 10.0f;
    }
    while (width / spacing < fewest_lines && spacing > 1e-6f) {
        spacing *= 0.1f;
    }
    return spacing;
}

layout::FrameParams make_frame(const Picture& picture) {
    layout::FrameParams frame{};
    fill_camera(frame, picture);
    fill_light(frame, picture);
    frame.half_extent = picture.half_extent;
    frame.ground_spacing = ground_spacing(picture.half_extent);
    frame.grid_origin = vec3(picture.grid.origin);
    frame.cell_width = static_cast<float>(picture.grid.cell_width);
    frame.grid_cells = picture.grid.cells;
    frame.top_count = static_cast<float>(picture.top_count);
    frame.top_speed = std::max(picture.top_speed, 1e-6f);
    const bool no_speeds = picture.ball_colour == BallColour::speed && picture.velocities == nullptr;
    frame.ball_colour = no_speeds ? COLOUR_TINTED : static_cast<layout::uint>(picture.ball_colour);
    for (std::size_t i = 0; i < sequential_palette.size(); ++i) {
        frame.sequential[i] = vec4(linear_from_srgb(sequential_palette[i]), 1.0f);
    }
    for (std::size_t i = 0; i < categorical_palette.size(); ++i) {
        frame.categorical[i] = vec4(linear_from_srgb(categorical_palette[i]), 1.0f);
    }
    return frame;
}

}  // namespace ballpit::view
