#include "view/far_balls.h"

#include <algorithm>
#include <cmath>

#include "view/view_program.h"

namespace ballpit::view {

namespace {

enum Location : GLuint { at_ball = 3, at_velocity = 4, at_value = 6 };  // as in all ball shaders

}  // namespace

float largest_across(const Picture& picture) {
    const Camera& camera = picture.camera;
    const vec3 nearest = glm::clamp(camera.position, -picture.half_extent, picture.half_extent);
    const float away = std::max(glm::distance(nearest, camera.position), 1e-6f);
    const float pixels_per_radian = 0.5f * static_cast<float>(picture.height) / std::tan(0.5f * camera.field_of_view);
    return static_cast<float>(picture.grid.cell_width) * pixels_per_radian / away;
}

bool all_far(const Picture& picture) { return picture.ball_count >= far_from && largest_across(picture) < far_below; }

FarBalls::FarBalls(const std::filesystem::path& shader_folder)
    : usual_(load_view_program(shader_folder, "ball_far")),
      valued_(load_view_program(shader_folder, "ball_far", {"VALUED"})) {}

// The buffers change places every substep, hence anew for each picture.
const gl::Program& FarBalls::use(const Picture& picture, bool valued) {
    const gl::Buffer& velocities = picture.velocities != nullptr ? *picture.velocities : *picture.positions;
    array_.floats(at_ball, *picture.positions, 4, sizeof(vec4), 0);
    array_.floats(at_velocity, velocities, 4, sizeof(vec4), 0);
    if (valued) {
        array_.floats(at_value, *picture.values, 1, sizeof(float), 0);
    }
    const gl::Program& program = valued ? valued_ : usual_;
    program.use();
    return program;
}

void FarBalls::draw(const Picture& picture) {
    array_.bind();
    glEnable(GL_PROGRAM_POINT_SIZE);
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(picture.ball_count));
    glDisable(GL_PROGRAM_POINT_SIZE);
}

}  // namespace ballpit::view
