#include "view/frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "view/far_balls.h"
#include "view/palette.h"

namespace ballpit::view {

namespace {

static_assert(static_cast<unsigned>(BallColour::tinted) == COLOUR_TINTED &&
              static_cast<unsigned>(BallColour::plain) == COLOUR_PLAIN &&
              static_cast<unsigned>(BallColour::speed) == COLOUR_SPEED &&
              static_cast<unsigned>(BallColour::cell) == COLOUR_CELL);
static_assert(static_cast<unsigned>(Palette::sequential) == PALETTE_SEQUENTIAL &&
              static_cast<unsigned>(Palette::diverging) == PALETTE_DIVERGING &&
              static_cast<unsigned>(Palette::categorical) == PALETTE_CATEGORICAL);
static_assert(std::tuple_size_v<decltype(sequential_palette)> == SEQUENTIAL_COLOURS &&
              std::tuple_size_v<decltype(diverging_palette)> == DIVERGING_COLOURS &&
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
    frame.picture_origin = {static_cast<float>(picture.x), static_cast<float>(picture.y)};
}

template <std::size_t N>
void fill_palette(vec4 (&colours)[N], const std::array<vec3, N>& palette) {
    for (std::size_t i = 0; i < N; ++i) {
        colours[i] = vec4(linear_from_srgb(palette[i]), 1.0f);
    }
}

void fill_colours(layout::FrameParams& frame, const Picture& picture) {
    frame.top_count = static_cast<float>(picture.top_count);
    frame.top_speed = std::max(picture.top_speed, 1e-6f);
    // Values have programs of their own; where there are none, or no velocities, nothing else is told either.
    const bool no_speeds = picture.ball_colour == BallColour::speed && picture.velocities == nullptr;
    const bool tinted = no_speeds || picture.ball_colour == BallColour::value;
    frame.ball_colour = tinted ? COLOUR_TINTED : static_cast<layout::uint>(picture.ball_colour);
    frame.value_palette = static_cast<layout::uint>(picture.value_palette);
    frame.value_low = picture.value_low;
    frame.value_high = picture.value_high;
    frame.no_value_colour = linear_from_srgb(no_value_colour);
    fill_palette(frame.sequential, sequential_palette);
    fill_palette(frame.diverging, diverging_palette);
    fill_palette(frame.categorical, categorical_palette);
}

void fill_overlay(layout::FrameParams& frame, const Picture& picture) {
    if (picture.overlay == nullptr) {
        return;
    }
    frame.arrow_seconds = picture.overlay->arrow_seconds;
    const std::optional<GridSlice>& slice = picture.overlay->slice;
    const auto plane = slice ? slice_plane(picture.grid, *slice, picture.camera.position) : std::nullopt;
    if (plane) {
        frame.slice_normal = plane->normal;
        frame.slice_place = plane->place;
        frame.slice_axis = static_cast<layout::uint>(slice->axis);
        frame.slice_layer = slice->layer;
        frame.cut_away = slice->cut_away ? 1.0f : 0.0f;
    }
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
    const bool shadows = picture.show_shadows && picture.look != Look::simple && fine_enough && !all_far(picture);
    frame.shadow_range = shadows ? frame.light_distance + glm::length(picture.half_extent) : 0.0f;
    frame.marker_radius = 0.045f * glm::length(picture.half_extent);
}

}  // namespace

float ground_spacing(const Box& box) {
    constexpr float most_lines = 60.0f;
    constexpr float fewest_lines = 3.0f;
    const float width = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
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
    const Box& box = picture.box;
    frame.box_lower = box.low;
    frame.box_upper = box.high;
    frame.ground_spacing = ground_spacing(box);
    frame.ground_reach = std::max(0.5f * std::max(box.high.x - box.low.x, box.high.y - box.low.y), 1e-6f);
    frame.grid_origin = vec3(picture.grid.origin);
    frame.cell_width = static_cast<float>(picture.grid.cell_width);
    frame.grid_cells = picture.grid.cells;
    fill_colours(frame, picture);
    fill_overlay(frame, picture);
    return frame;
}

}  // namespace ballpit::view
