#include "view/view_program.h"

#include <array>

#include "view/frame.h"

namespace ballpit::view {

namespace {

void bind_frame(const gl::Program& program) {
    const GLuint block = glGetUniformBlockIndex(program.id(), "Frame");
    if (block != GL_INVALID_INDEX) {
        glUniformBlockBinding(program.id(), block, BLOCK_FRAME);
    }
}

}  // namespace

gl::Program load_view_program(const std::filesystem::path& shader_folder, const std::string& stem,
                              const std::vector<std::string_view>& defines) {
    const std::array<gl::ShaderStage, 2> stages = {
        gl::ShaderStage{GL_VERTEX_SHADER, gl::load_shader(shader_folder, stem + ".vert", defines)},
        gl::ShaderStage{GL_FRAGMENT_SHADER, gl::load_shader(shader_folder, stem + ".frag", defines)}};
    gl::Program program(stages);
    bind_frame(program);
    program.use();
    glUniform1i(program.uniform("surface"), unit_surface);
    glUniform1i(program.uniform("shadow_map"), unit_shadow_map);
    glUniform1i(program.uniform("elements"), unit_elements);
    return program;
}

gl::Program load_compute_program(const std::filesystem::path& shader_folder, const std::string& stem,
                                 const std::vector<std::string_view>& defines) {
    const std::array stages = {
        gl::ShaderStage{GL_COMPUTE_SHADER, gl::load_shader(shader_folder, stem + ".comp", defines)}};
    gl::Program program(stages);
    bind_frame(program);
    return program;
}

}  // namespace ballpit::view
