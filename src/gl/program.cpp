#include "gl/program.h"

#include <string>
#include <vector>

#include "gl/debug.h"
#include "gl/error.h"

namespace ballpit::gl {

namespace {

void delete_shader(GLuint id) { glDeleteShader(id); }
using ShaderHandle = Handle<delete_shader>;

ShaderHandle compile(const ShaderStage& stage) {
    ShaderHandle shader(glCreateShader(stage.kind));
    const char* text = stage.source.text.c_str();
    glShaderSource(shader.id(), 1, &text, nullptr);
    glCompileShader(shader.id());
    GLint good = 0;
    glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &good);
    if (good == 0) {
        GLint length = 0;
        glGetShaderiv(shader.id(), GL_INFO_LOG_LENGTH, &length);
        std::string log(static_cast<std::size_t>(length) + 1, '\0');
        glGetShaderInfoLog(shader.id(), length, &length, log.data());
        log.resize(static_cast<std::size_t>(length));
        throw ShaderError("shader " + stage.source.name + " does not compile:\n" + readable_log(stage.source, log));
    }
    return shader;
}

}  // namespace

Program::Program(std::span<const ShaderStage> stages) : handle_(glCreateProgram()) {
    std::vector<ShaderHandle> shaders;
    std::string names;
    for (const ShaderStage& stage : stages) {
        shaders.push_back(compile(stage));
        glAttachShader(id(), shaders.back().id());
        names += (names.empty() ? "" : " + ") + stage.source.name;
    }
    glLinkProgram(id());
    for (const ShaderHandle& shader : shaders) {
        glDetachShader(id(), shader.id());
    }
    GLint good = 0;
    glGetProgramiv(id(), GL_LINK_STATUS, &good);
    if (good == 0) {
        GLint length = 0;
        glGetProgramiv(id(), GL_INFO_LOG_LENGTH, &length);
        std::string log(static_cast<std::size_t>(length) + 1, '\0');
        glGetProgramInfoLog(id(), length, &length, log.data());
        log.resize(static_cast<std::size_t>(length));
        throw ShaderError("program " + names + " does not link:\n" + log);
    }
    label_object(GL_PROGRAM, id(), names);
}

}  // namespace ballpit::gl
