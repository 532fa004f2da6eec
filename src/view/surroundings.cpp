#include "view/surroundings.h"

#include "view/view_program.h"

namespace ballpit::view {

namespace {

constexpr GLsizei edges_of_a_box = 12;

}  // namespace

Surroundings::Surroundings(const std::filesystem::path& shader_folder)
    : background_(load_view_program(shader_folder, "background")),
      simple_background_(load_view_program(shader_folder, "background", {"SIMPLE"})),
      ground_(load_view_program(shader_folder, "ground")),
      simple_ground_(load_view_program(shader_folder, "ground", {"SIMPLE"})),
      box_(load_view_program(shader_folder, "box")),
      light_marker_(load_view_program(shader_folder, "light_marker")) {}

void Surroundings::draw_background(bool simple) const {
    (simple ? simple_background_ : background_).use();
    no_attributes_.bind();
    glDisable(GL_DEPTH_TEST);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Surroundings::draw_ground(bool simple) const {
    (simple ? simple_ground_ : ground_).use();
    no_attributes_.bind();
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);  // from below, the ground would hide the balls
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glDisable(GL_CULL_FACE);
}

void Surroundings::draw_box() const {
    box_.use();
    no_attributes_.bind();
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    glDepthMask(GL_FALSE);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, edges_of_a_box);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

void Surroundings::draw_light_marker() const {
    light_marker_.use();
    no_attributes_.bind();
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE, GL_ZERO, GL_ONE);
    glDepthMask(GL_FALSE);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

}  // namespace ballpit::view
