#include "view/renderer.h"

#include <cassert>
#include <span>

#include "gl/debug.h"
#include "view/ball_drawing.h"
#include "view/cell_drawing.h"
#include "view/frame.h"
#include "view/surroundings.h"

namespace ballpit::view {

struct Renderer::Parts {
    Parts(const std::filesystem::path& shader_folder, const Model& model)
        : balls(shader_folder, model),
          cells(shader_folder),
          surroundings(shader_folder),
          frame("frame", sizeof(layout::FrameParams), GL_DYNAMIC_DRAW) {}

    BallDrawing balls;
    CellDrawing cells;
    Surroundings surroundings;
    gl::Buffer frame;
};

Renderer::Renderer(const std::filesystem::path& shader_folder, const Model& ball_model)
    : parts_(std::make_unique<Parts>(shader_folder, ball_model)) {}

Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

void Renderer::set_model(const Model& ball_model) { parts_->balls.set_model(ball_model); }

void Renderer::draw(const Picture& picture) {
    if (picture.width < 1 || picture.height < 1) {
        return;  // a minimised window
    }
    const gl::DebugGroup group("draw");
    const layout::FrameParams frame = make_frame(picture);
    parts_->frame.write(std::as_bytes(std::span(&frame, 1)));
    parts_->frame.bind_base(GL_UNIFORM_BUFFER, BLOCK_FRAME);
    glViewport(0, 0, picture.width, picture.height);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LEQUAL);
    glClear(GL_DEPTH_BUFFER_BIT);

    const bool has_balls = picture.ball_count != 0 && picture.positions != nullptr;
    assert(!has_balls || picture.positions->size() >= picture.ball_count * sizeof(vec4));
    parts_->surroundings.draw_background();
    if (picture.show_ground) {
        parts_->surroundings.draw_ground();
        if (has_balls && picture.camera.position.z > -picture.half_extent.z) {
            parts_->balls.draw_shadows(picture);
        }
    }
    if (has_balls) {
        parts_->balls.draw_balls(picture);
    }
    if (picture.show_box) {
        parts_->surroundings.draw_box();
    }
    if (picture.show_cells && picture.cell_ranges != nullptr) {
        parts_->cells.draw(picture);
    }
    if (picture.show_light) {
        parts_->surroundings.draw_light_marker();
    }
    glDisable(GL_DEPTH_TEST);
    glBindVertexArray(0);
}

}  // namespace ballpit::view
