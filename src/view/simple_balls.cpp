#include "view/simple_balls.h"

#include <array>
#include <cmath>

#include "view/far_balls.h"
#include "view/view_program.h"

namespace ballpit::view {

namespace {

enum Location : GLuint { at_ball = 3, at_velocity = 4, at_value = 6 };  // as in all ball shaders

// Points are larger than balls are wide where perspective pulls them long.
constexpr float widest_pull = 2.0f;

// Pixels around the picture in which the middle of a ball may lie that reaches into it.
GLint margin(float largest_point) { return static_cast<GLint>(std::ceil(0.5f * largest_point)); }

}  // namespace

SimpleBalls::SimpleBalls(const std::filesystem::path& shader_folder)
    : usual_(load_view_program(shader_folder, "ball_simple")),
      valued_(load_view_program(shader_folder, "ball_simple", {"VALUED"})) {
    std::array<GLfloat, 2> sizes{};
    glGetFloatv(GL_POINT_SIZE_RANGE, sizes.data());
    largest_point_ = sizes[1];
}

bool SimpleBalls::can_draw(const Picture& picture) const {
    return picture.look == Look::simple && widest_pull * largest_across(picture) < largest_point_;
}

// The buffers change places every substep, hence anew for each picture.
const gl::Program& SimpleBalls::use(const Picture& picture, bool valued) {
    const gl::Buffer& velocities = picture.velocities != nullptr ? *picture.velocities : *picture.positions;
    array_.floats(at_ball, *picture.positions, 4, sizeof(vec4), 0);
    array_.floats(at_velocity, velocities, 4, sizeof(vec4), 0);
    if (valued) {
        array_.floats(at_value, *picture.values, 1, sizeof(float), 0);
    }
    const gl::Program& program = valued ? valued_ : usual_;
    program.use();
    const GLint around = margin(largest_point_);
    const auto share = [around](int pixels) {
        return static_cast<float>(pixels) / static_cast<float>(pixels + 2 * around);
    };
    glUniform2f(program.uniform("margins"), share(picture.width), share(picture.height));
    return program;
}

// A point whose middle is outside the viewport is not drawn at all: so the viewport is larger than the picture, which
// the scissor keeps.
void SimpleBalls::draw(const Picture& picture) {
    const GLint around = margin(largest_point_);
    array_.bind();
    glViewport(picture.x - around, picture.y - around, picture.width + 2 * around, picture.height + 2 * around);
    glEnable(GL_PROGRAM_POINT_SIZE);
    const auto balls = static_cast<GLsizei>(picture.ball_count);
    if (picture.order != nullptr) {
        array_.indices(*picture.order);
        glDrawElements(GL_POINTS, balls, GL_UNSIGNED_INT, nullptr);
    } else {
        glDrawArrays(GL_POINTS, 0, balls);
    }
    glDisable(GL_PROGRAM_POINT_SIZE);
    glViewport(picture.x, picture.y, picture.width, picture.height);
}

}  // namespace ballpit::view
