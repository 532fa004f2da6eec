#include "view/ball_drawing.h"

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "view/frame.h"
#include "view/view_program.h"

namespace ballpit::view {

namespace {

// Attribute locations of ball.vert, ball_impostor.vert, ball_shadow.vert and ball_contact.vert.
enum Location : GLuint { at_vertex, at_normal, at_uv, at_ball, at_velocity };

constexpr GLint square_corners = 4;
constexpr float coarse_below = 32.0f;  // pixels across

template <class T>
gl::Buffer static_buffer(std::string_view label, std::span<const T> elements) {
    gl::Buffer buffer(label, elements.size_bytes(), GL_STATIC_DRAW);
    buffer.write(std::as_bytes(elements));
    return buffer;
}

gl::Texture make_texture(const Image& image) {
    constexpr std::array<unsigned char, 4> white = {255, 255, 255, 255};
    return image.pixels.empty() ? gl::Texture(1, 1, white) : gl::Texture(image.width, image.height, image.pixels);
}

// The buffers change places every substep, hence anew for each picture. Without velocities the positions stand in:
// no shader then looks at them.
void point_at_balls(gl::VertexArray& array, const Picture& picture) {
    const gl::Buffer& velocities = picture.velocities != nullptr ? *picture.velocities : *picture.positions;
    array.floats(at_ball, *picture.positions, 4, sizeof(vec4), 0, 1);
    array.floats(at_velocity, velocities, 4, sizeof(vec4), 0, 1);
}

}  // namespace

BallDrawing::BallDrawing(const std::filesystem::path& shader_folder, const Model& model)
    : model_program_(load_view_program(shader_folder, "ball")),
      impostor_program_(load_view_program(shader_folder, "ball_impostor")),
      shadow_program_(load_view_program(shader_folder, "ball_shadow")),
      contact_program_(load_view_program(shader_folder, "ball_contact")) {
    constexpr std::array<glm::vec2, square_corners> corners = {glm::vec2(-1.0f, -1.0f), glm::vec2(1.0f, -1.0f),
                                                               glm::vec2(-1.0f, 1.0f), glm::vec2(1.0f, 1.0f)};
    square_ = static_buffer("square", std::span<const glm::vec2>(corners));
    square_array_.floats(at_vertex, square_, 2, sizeof(glm::vec2), 0);
    set_model(model);
}

void BallDrawing::set_model(const Model& model) {
    std::vector<Mesh> meshes;
    meshes.push_back(make_mesh(model));
    for (const Model& coarser : model.coarser) {
        meshes.push_back(make_mesh(coarser));
    }
    meshes_ = std::move(meshes);
}

BallDrawing::Mesh BallDrawing::make_mesh(const Model& model) {
    assert(!model.parts.empty() && !model.indices.empty());
    Mesh mesh;
    mesh.closed = model.closed;
    mesh.vertices = static_buffer("ball model vertices", std::span(model.vertices));
    mesh.array.floats(at_vertex, mesh.vertices, 3, sizeof(Vertex), offsetof(Vertex, position));
    mesh.array.floats(at_normal, mesh.vertices, 3, sizeof(Vertex), offsetof(Vertex, normal));
    mesh.array.floats(at_uv, mesh.vertices, 2, sizeof(Vertex), offsetof(Vertex, uv));
    mesh.indices = static_buffer("ball model indices", std::span(model.indices));
    mesh.array.indices(mesh.indices);
    for (const Part& part : model.parts) {
        const Material& material = part.material;
        mesh.surfaces.push_back({static_cast<GLsizei>(part.index_count), part.first_index, material.diffuse,
                                 material.specular, material.shininess, make_texture(material.texture)});
    }
    return mesh;
}

// By the size in the picture of the largest balls, which a cell is made to hold.
BallDrawing::Mesh& BallDrawing::mesh_for(const Picture& picture) {
    const Camera& camera = picture.camera;
    const float pixels_per_radian = 0.5f * static_cast<float>(picture.height) / std::tan(0.5f * camera.field_of_view);
    const float across = static_cast<float>(picture.grid.cell_width) * pixels_per_radian;
    return across < coarse_below * glm::length(camera.position) ? meshes_.back() : meshes_.front();
}

void BallDrawing::use_surface(const gl::Program& program, const Surface& surface) const {
    glUniform3f(program.uniform("diffuse"), surface.diffuse.x, surface.diffuse.y, surface.diffuse.z);
    glUniform3f(program.uniform("specular"), surface.specular.x, surface.specular.y, surface.specular.z);
    glUniform1f(program.uniform("shininess"), surface.shininess);
    surface.texture.bind(unit_surface);
}

void BallDrawing::draw_shadow_map(const Picture& picture) {
    point_at_balls(square_array_, picture);
    shadow_program_.use();
    square_array_.bind();
    glEnable(GL_DEPTH_TEST);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, square_corners, static_cast<GLsizei>(picture.ball_count));
    glDisable(GL_DEPTH_TEST);
}

void BallDrawing::draw_contacts(const Picture& picture) {
    point_at_balls(square_array_, picture);
    contact_program_.use();
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
    const auto balls = static_cast<GLsizei>(picture.ball_count);
    glEnable(GL_DEPTH_TEST);
    if (picture.look == Look::impostor) {
        point_at_balls(square_array_, picture);
        impostor_program_.use();
        use_surface(impostor_program_, meshes_.front().surfaces.front());
        square_array_.bind();
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, square_corners, balls);
        return;
    }
    Mesh& mesh = mesh_for(picture);
    point_at_balls(mesh.array, picture);
    model_program_.use();
    mesh.array.bind();
    (mesh.closed ? glEnable : glDisable)(GL_CULL_FACE);
    for (const Surface& surface : mesh.surfaces) {
        use_surface(model_program_, surface);
        glDrawElementsInstanced(GL_TRIANGLES, surface.index_count, GL_UNSIGNED_INT,
                                reinterpret_cast<const void*>(surface.first_index * sizeof(std::uint32_t)), balls);
    }
    glDisable(GL_CULL_FACE);
}

}  // namespace ballpit::view
