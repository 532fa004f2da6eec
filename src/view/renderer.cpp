#include "view/renderer.h"

#include <cassert>
#include <span>

#include "gl/debug.h"
#include "gl/depth_map.h"
#include "view/ball_drawing.h"
#include "view/cell_drawing.h"
#include "view/frame.h"
#include "view/overlay_drawing.h"
#include "view/surroundings.h"

namespace ballpit::view {

struct Renderer::Parts {
    Parts(const std::filesystem::path& shader_folder, const Model& model, bool computes)
        : balls(shader_folder, model, computes),
          cells(shader_folder),
          overlay(shader_folder),
          surroundings(shader_folder),
          frame("frame", sizeof(layout::FrameParams), GL_DYNAMIC_DRAW) {}

    void draw_shadow_map(const Picture& picture) {
        GLint target = 0;
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
        shadow_map.bind_target();
        glClear(GL_DEPTH_BUFFER_BIT);
        if (picture.ball_count != 0) {
            balls.draw_shadow_map(picture);
        }
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(target));
    }

    void draw_surroundings(const Picture& picture) {
        glViewport(picture.x, picture.y, picture.width, picture.height);
        glScissor(picture.x, picture.y, picture.width, picture.height);
        glEnable(GL_SCISSOR_TEST);
        glClear(GL_DEPTH_BUFFER_BIT);
        const bool simple = picture.look == Look::simple;
        shadow_map.bind(unit_shadow_map);
        surroundings.draw_background(simple);
        if (picture.show_ground) {
            surroundings.draw_ground(simple);
            if (!simple && picture.ball_count != 0 && picture.camera.position.z > picture.box.low.z) {
                balls.draw_contacts(picture);
            }
        }
    }

    void draw_overlay(const Picture& picture) {
        if (picture.show_box) {
            surroundings.draw_box();
        }
        const bool sliced = picture.overlay != nullptr && picture.overlay->slice;
        if (picture.show_cells && picture.cell_ranges != nullptr && !sliced) {
            cells.draw(picture);
        }
        if (picture.show_light) {
            surroundings.draw_light_marker();
        }
        overlay.draw(picture, false);
        if (picture.ball_count != 0) {
            balls.draw_arrows(picture);
            balls.draw_ghosts(picture);
        }
        overlay.draw(picture, true);
    }

    BallDrawing balls;
    CellDrawing cells;
    OverlayDrawing overlay;
    Surroundings surroundings;
    gl::Buffer frame;
    gl::DepthMap shadow_map{shadow_map_size};
};

Renderer::Renderer(const std::filesystem::path& shader_folder, const Model& ball_model, bool computes)
    : parts_(std::make_unique<Parts>(shader_folder, ball_model, computes)) {}

Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

void Renderer::set_model(const Model& ball_model) { parts_->balls.set_model(ball_model); }

void Renderer::draw(const Picture& picture, const PassMark& mark) {
    if (picture.width < 1 || picture.height < 1) {
        return;  // a minimised window
    }
    const gl::DebugGroup group("draw");
    const auto done = [&mark](Pass pass) {
        if (mark) {
            mark(pass);
        }
    };
    const layout::FrameParams frame = make_frame(picture);
    parts_->frame.write(std::as_bytes(std::span(&frame, 1)));
    parts_->frame.bind_base(GL_UNIFORM_BUFFER, BLOCK_FRAME);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LEQUAL);
    assert(picture.ball_count == 0 || picture.positions->size() >= picture.ball_count * sizeof(vec4));
    parts_->overlay.prepare(picture);
    parts_->balls.prepare(picture);
    done(Pass::visibility);
    if (frame.shadow_range != 0.0f) {
        parts_->draw_shadow_map(picture);
    }
    done(Pass::shadows);
    parts_->draw_surroundings(picture);
    done(Pass::surroundings);
    if (picture.ball_count != 0) {
        parts_->balls.draw_balls(picture);
    }
    done(Pass::balls);
    parts_->draw_overlay(picture);
    done(Pass::overlay);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_DEPTH_TEST);
    glBindVertexArray(0);
}

}  // namespace ballpit::view
