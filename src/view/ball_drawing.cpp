#include "view/ball_drawing.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "view/far_balls.h"
#include "view/frame.h"

namespace ballpit::view {

namespace {

constexpr GLint square_corners = 4;
constexpr float coarse_below = 32.0f;  // pixels across

void point_at(gl::VertexArray& array, BallAttribute location, const gl::Buffer* buffer, float otherwise) {
    if (buffer != nullptr) {
        array.floats(location, *buffer, 1, sizeof(float), 0, 1);
        return;
    }
    array.bind();
    glDisableVertexAttribArray(location);
    glVertexAttrib1f(location, otherwise);
}

bool shows_values(const Picture& picture) {
    return picture.ball_colour == BallColour::value && picture.values != nullptr;
}

bool cuts_away(const Picture& picture) {
    const std::optional<GridSlice>& slice = picture.overlay->slice;
    return slice && slice->cut_away && slice_plane(picture.grid, *slice, picture.camera.position);
}

}  // namespace

BallDrawing::BallDrawing(const std::filesystem::path& shader_folder, const Model& model, bool computes)
    : model_programs_(shader_folder, "ball"),
      impostor_programs_(shader_folder, "ball_impostor"),
      shadow_programs_(shader_folder, "ball_shadow"),
      contact_programs_(shader_folder, "ball_contact"),
      arrow_programs_(shader_folder, "arrow"),
      far_balls_(shader_folder, "ball_far"),
      simple_balls_(shader_folder) {
    if (computes && PixelBalls::possible()) {
        pixel_balls_.emplace(shader_folder);
    }
    constexpr std::array<glm::vec2, square_corners> corners = {glm::vec2(-1.0f, -1.0f), glm::vec2(1.0f, -1.0f),
                                                               glm::vec2(-1.0f, 1.0f), glm::vec2(1.0f, 1.0f)};
    square_ = gl::Buffer("square", sizeof(corners), GL_STATIC_DRAW);
    square_.write(std::as_bytes(std::span(corners)));
    square_array_.floats(at_vertex, square_, 2, sizeof(glm::vec2), 0);
    set_model(model);
}

const gl::Program& BallDrawing::use(const BallPrograms& programs) const {
    const gl::Program& program = faded_ ? programs.faded : programs.whole;
    program.use();
    return program;
}

const gl::Program& BallDrawing::use(const LookPrograms& programs, const Picture& picture, bool ghosts) const {
    const bool valued = shows_values(picture);
    if (way_ == Way::pixels) {
        const gl::Program& program = valued ? programs.listed_valued : programs.listed;
        program.use();
        return program;
    }
    const gl::Program& program = use(valued ? programs.valued : programs.usual);
    glUniform1i(program.uniform("ghosts"), ghosts ? 1 : 0);
    return program;
}

void BallDrawing::point_at_instances(gl::VertexArray& array, const Picture& picture) const {
    point_at_balls(array, picture, 1);
    point_at(array, at_presence, presences_.empty() ? nullptr : &presence_buffer_, presence_);
    point_at(array, at_value, shows_values(picture) ? picture.values : nullptr, 0.0f);
}

// All balls, or those of the list.
void BallDrawing::point_at_drawn(gl::VertexArray& array, const Picture& picture) const {
    if (way_ != Way::pixels) {
        point_at_instances(array, picture);
        return;
    }
    const gl::Buffer& balls = pixel_balls_->near_balls();
    array.floats(at_ball, balls, 4, sizeof(NearBall), offsetof(NearBall, state), 1);
    array.floats(at_velocity, balls, 4, sizeof(NearBall), offsetof(NearBall, velocity), 1);
    array.floats(at_value, balls, 1, sizeof(NearBall), offsetof(NearBall, value), 1);
    array.uints(at_number, balls, 1, sizeof(NearBall), offsetof(NearBall, number), 1);
}

BallDrawing::Way BallDrawing::way_for(const Picture& picture) const {
    if (faded_ || picture.ball_count == 0) {
        return Way::instances;
    }
    if (simple_balls_.can_draw(picture)) {
        return Way::simple;
    }
    if (pixel_balls_ && pixel_balls_->can_draw(picture)) {
        return Way::pixels;
    }
    return all_far(picture) ? Way::points : Way::instances;
}

// The list is drawn as squares or by each surface of the model.
void BallDrawing::find_pixels(const Picture& picture) {
    near_draws_.clear();
    if (picture.look != Look::model) {
        near_draws_.push_back({square_corners, 0, 0, 0, 0});
    } else {
        for (const BallSurface& surface : mesh_for(picture).surfaces) {
            near_draws_.push_back({static_cast<std::uint32_t>(surface.index_count), 0,
                                   static_cast<std::uint32_t>(surface.first_index), 0, 0});
        }
    }
    pixel_balls_->find(picture, shows_values(picture), near_draws_);
}

void BallDrawing::prepare(const Picture& picture) {
    prepare_presences(picture);
    way_ = way_for(picture);
    if (way_ == Way::pixels) {
        find_pixels(picture);
    }
}

void BallDrawing::prepare_presences(const Picture& picture) {
    presences_.clear();
    presence_ = picture.overlay != nullptr ? 1.0f - std::clamp(picture.overlay->fade_others, 0.0f, 1.0f) : 1.0f;
    faded_ = picture.overlay != nullptr && (presence_ < 1.0f || cuts_away(picture));
    if (!faded_ || picture.overlay->highlights.empty() || picture.ball_count == 0) {
        return;
    }
    constexpr float never_left_out = 2.0f;
    presences_.assign(picture.ball_count, presence_);
    for (const BallHighlight& highlight : picture.overlay->highlights) {
        if (highlight.ball < picture.ball_count) {
            presences_[highlight.ball] = never_left_out;
        }
    }
    const auto bytes = std::as_bytes(std::span(presences_));
    if (presence_buffer_.size() < bytes.size()) {
        presence_buffer_ = gl::Buffer("presence of balls", bytes.size(), GL_STREAM_DRAW);
    }
    presence_buffer_.write(bytes);
}

void BallDrawing::set_model(const Model& model) {
    std::vector<BallMesh> meshes;
    meshes.emplace_back(model);
    for (const Model& coarser : model.coarser) {
        meshes.emplace_back(coarser);
    }
    meshes_ = std::move(meshes);
}

// By the size in the picture of the largest balls, which a cell is made to hold.
BallMesh& BallDrawing::mesh_for(const Picture& picture) {
    const Camera& camera = picture.camera;
    const float pixels_per_radian = 0.5f * static_cast<float>(picture.height) / std::tan(0.5f * camera.field_of_view);
    const float across = static_cast<float>(picture.grid.cell_width) * pixels_per_radian;
    return across < coarse_below * glm::length(camera.position) ? meshes_.back() : meshes_.front();
}

void BallDrawing::use_surface(const gl::Program& program, const BallSurface& surface) const {
    glUniform3f(program.uniform("diffuse"), surface.diffuse.x, surface.diffuse.y, surface.diffuse.z);
    glUniform3f(program.uniform("specular"), surface.specular.x, surface.specular.y, surface.specular.z);
    glUniform1f(program.uniform("shininess"), surface.shininess);
    surface.texture.bind(unit_surface);
}

void BallDrawing::draw_shadow_map(const Picture& picture) {
    point_at_instances(square_array_, picture);
    use(shadow_programs_);
    square_array_.bind();
    glEnable(GL_DEPTH_TEST);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, square_corners, static_cast<GLsizei>(picture.ball_count));
    glDisable(GL_DEPTH_TEST);
}

void BallDrawing::draw_contacts(const Picture& picture) {
    if (all_far(picture)) {
        return;  // discs of a few pixels, below balls that hide them
    }
    point_at_instances(square_array_, picture);
    use(contact_programs_);
    square_array_.bind();
    glEnable(GL_BLEND);
    glBlendFunc(GL_ZERO, GL_SRC_COLOR);
    glDepthMask(GL_FALSE);
    glDisable(GL_DEPTH_TEST);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, square_corners, static_cast<GLsizei>(picture.ball_count));
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
}

void BallDrawing::draw_balls(const Picture& picture) {
    const bool all_ghosts = presence_ < 1.0f && presences_.empty();
    if (!all_ghosts) {
        glEnable(GL_DEPTH_TEST);
        draw_look(picture, false);
    }
}

void BallDrawing::draw_ghosts(const Picture& picture) {
    if (presence_ <= 0.0f || presence_ >= 1.0f) {
        return;
    }
    glEnable(GL_DEPTH_TEST);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    draw_look(picture, true);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthFunc(GL_EQUAL);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    draw_look(picture, true);
    glDisable(GL_BLEND);
    glDepthFunc(GL_LEQUAL);
}

void BallDrawing::draw_look(const Picture& picture, bool ghosts) {
    const bool valued = shows_values(picture);
    const BallSurface& surface = meshes_.front().surfaces.front();
    switch (way_) {
        case Way::simple:
            use_surface(simple_balls_.use(picture, valued), surface);
            simple_balls_.draw(picture);
            return;
        case Way::points:
            use_surface(far_balls_.use(picture, valued), surface);
            far_balls_.draw(picture, nullptr);
            return;
        case Way::pixels:
            use_surface(pixel_balls_->use(valued), surface);
            pixel_balls_->draw();
            break;
        case Way::instances:
            break;
    }
    if (picture.look == Look::model) {
        draw_models(picture, ghosts);
    } else {
        draw_impostors(picture, ghosts);  // simple from near by: points have a largest size
    }
}

void BallDrawing::draw_impostors(const Picture& picture, bool ghosts) {
    point_at_drawn(square_array_, picture);
    use_surface(use(impostor_programs_, picture, ghosts), meshes_.front().surfaces.front());
    square_array_.bind();
    if (way_ == Way::pixels) {
        glDrawArraysIndirect(GL_TRIANGLE_STRIP, pixel_balls_->bind_draw(0));
    } else {
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, square_corners, static_cast<GLsizei>(picture.ball_count));
    }
}

void BallDrawing::draw_models(const Picture& picture, bool ghosts) {
    BallMesh& mesh = mesh_for(picture);
    point_at_drawn(mesh.array, picture);
    const gl::Program& program = use(model_programs_, picture, ghosts);
    mesh.array.bind();
    (mesh.closed ? glEnable : glDisable)(GL_CULL_FACE);
    for (std::size_t i = 0; i < mesh.surfaces.size(); ++i) {
        const BallSurface& surface = mesh.surfaces[i];
        use_surface(program, surface);
        if (way_ == Way::pixels) {
            glDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, pixel_balls_->bind_draw(i));
        } else {
            glDrawElementsInstanced(GL_TRIANGLES, surface.index_count, GL_UNSIGNED_INT,
                                    reinterpret_cast<const void*>(surface.first_index * sizeof(std::uint32_t)),
                                    static_cast<GLsizei>(picture.ball_count));
        }
    }
    glDisable(GL_CULL_FACE);
}

void BallDrawing::draw_arrows(const Picture& picture) {
    if (picture.overlay == nullptr || picture.overlay->arrow_seconds <= 0.0f || picture.velocities == nullptr) {
        return;
    }
    constexpr GLsizei corners = 9;  // a shaft of two triangles and a head
    point_at_instances(ball_array_, picture);
    use(arrow_programs_);
    ball_array_.bind();
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    glDrawArraysInstanced(GL_TRIANGLES, 0, corners, static_cast<GLsizei>(picture.ball_count));
    glDisable(GL_BLEND);
}

}  // namespace ballpit::view
