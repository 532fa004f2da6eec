#include "view/ball_points.h"

#include "view/view_program.h"

namespace ballpit::view {

void point_at_balls(gl::VertexArray& array, const Picture& picture, GLuint divisor) {
    const gl::Buffer& velocities = picture.velocities != nullptr ? *picture.velocities : *picture.positions;
    array.floats(at_ball, *picture.positions, 4, sizeof(vec4), 0, divisor);
    array.floats(at_velocity, velocities, 4, sizeof(vec4), 0, divisor);
}

BallPoints::BallPoints(const std::filesystem::path& shader_folder, const std::string& stem)
    : usual_(load_view_program(shader_folder, stem)), valued_(load_view_program(shader_folder, stem, {"VALUED"})) {}

const gl::Program& BallPoints::use(const Picture& picture, bool valued) {
    point_at_balls(array_, picture, 0);
    if (valued) {
        array_.floats(at_value, *picture.values, 1, sizeof(float), 0);
    }
    const gl::Program& program = valued ? valued_ : usual_;
    program.use();
    return program;
}

void BallPoints::draw(const Picture& picture, const gl::Buffer* order) {
    array_.bind();
    glEnable(GL_PROGRAM_POINT_SIZE);
    if (order == nullptr) {
        glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(picture.ball_count));
    } else if (picture.order_count != 0) {
        array_.indices(*order);
        glDrawElements(GL_POINTS, static_cast<GLsizei>(picture.order_count), GL_UNSIGNED_INT, nullptr);
    }
    glDisable(GL_PROGRAM_POINT_SIZE);
}

}  // namespace ballpit::view
