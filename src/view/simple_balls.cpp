#include "view/simple_balls.h"

#include <array>
#include <cmath>

#include "view/far_balls.h"

namespace ballpit::view {

namespace {

// Points are larger than balls are wide where perspective pulls them long.
constexpr float widest_pull = 2.0f;

// Pixels around the picture in which the middle of a ball may lie that reaches into it.
GLint margin(float largest_point) { return static_cast<GLint>(std::ceil(0.5f * largest_point)); }

}  // namespace

SimpleBalls::SimpleBalls(const std::filesystem::path& shader_folder) : points_(shader_folder, "ball_simple") {
    std::array<GLfloat, 2> sizes{};
    glGetFloatv(GL_POINT_SIZE_RANGE, sizes.data());
    largest_point_ = sizes[1];
}

bool SimpleBalls::can_draw(const Picture& picture) const {
    return picture.look == Look::simple && widest_pull * largest_across(picture) < largest_point_;
}

const gl::Program& SimpleBalls::use(const Picture& picture, bool valued) {
    const gl::Program& program = points_.use(picture, valued);
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
    glViewport(picture.x - around, picture.y - around, picture.width + 2 * around, picture.height + 2 * around);
    points_.draw(picture, picture.order);
    glViewport(picture.x, picture.y, picture.width, picture.height);
}

}  // namespace ballpit::view
