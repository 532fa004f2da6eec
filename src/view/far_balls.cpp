#include "view/far_balls.h"

#include <algorithm>
#include <cmath>

namespace ballpit::view {

float largest_across(const Picture& picture) {
    const Camera& camera = picture.camera;
    const vec3 nearest = glm::clamp(camera.position, -picture.half_extent, picture.half_extent);
    const float away = std::max(glm::distance(nearest, camera.position), 1e-6f);
    const float pixels_per_radian = 0.5f * static_cast<float>(picture.height) / std::tan(0.5f * camera.field_of_view);
    return static_cast<float>(picture.grid.cell_width) * pixels_per_radian / away;
}

bool all_far(const Picture& picture) { return picture.ball_count >= far_from && largest_across(picture) < far_below; }

}  // namespace ballpit::view
