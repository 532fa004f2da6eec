#include "support/active_resources.h"

#include <algorithm>
#include <array>
#include <vector>

namespace ballpit::test {

namespace {

GLint resource_count(GLuint program, GLenum interface) {
    GLint count = 0;
    glGetProgramInterfaceiv(program, interface, GL_ACTIVE_RESOURCES, &count);
    return count;
}

std::string resource_name(GLuint program, GLenum interface, GLuint index) {
    std::array<char, 256> name{};
    GLsizei length = 0;
    glGetProgramResourceName(program, interface, index, name.size(), &length, name.data());
    return {name.data(), static_cast<std::size_t>(length)};
}

GLint resource_property(GLuint program, GLenum interface, GLuint index, GLenum property) {
    GLint value = -1;
    glGetProgramResourceiv(program, interface, index, 1, &property, 1, nullptr, &value);
    return value;
}

std::string line_of(const std::string& what, std::vector<std::string> names) {
    std::ranges::sort(names);
    std::string line = "    " + what + ":";
    for (const std::string& name : names) {
        line += " " + name;
    }
    return line + (names.empty() ? " none\n" : "\n");
}

}  // namespace

std::string program_title(const Program& program) {
    std::string title(shader_name(program.shader));
    for (const std::string_view define : gpu::defines_of(program.features)) {
        title.append(" ").append(define);
    }
    return title;
}

std::string program_paragraph(gpu::Programs& programs, const Program& program) {
    const GLuint id = programs.get(program).program.id();
    std::vector<std::string> buffers;
    for (GLint i = 0; i < resource_count(id, GL_SHADER_STORAGE_BLOCK); ++i) {
        const auto index = static_cast<GLuint>(i);
        const GLint binding = resource_property(id, GL_SHADER_STORAGE_BLOCK, index, GL_BUFFER_BINDING);
        buffers.push_back(resource_name(id, GL_SHADER_STORAGE_BLOCK, index) + "@" + std::to_string(binding));
    }
    std::vector<std::string> constants;
    std::vector<std::string> uniforms;
    for (GLint i = 0; i < resource_count(id, GL_UNIFORM); ++i) {
        const auto index = static_cast<GLuint>(i);
        const std::string name = resource_name(id, GL_UNIFORM, index);
        const bool in_block = resource_property(id, GL_UNIFORM, index, GL_BLOCK_INDEX) >= 0;
        // "ParamsBlock.gain" or "params.gain": drivers differ in whose name they put first.
        (in_block ? constants : uniforms).push_back(in_block ? name.substr(name.rfind('.') + 1) : name);
    }
    return program_title(program) + "\n" + line_of("buffers", buffers) + line_of("constants", constants) +
           line_of("uniforms", uniforms);
}

}  // namespace ballpit::test
