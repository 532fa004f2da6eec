// A linked program, and its uniforms by name.
#pragma once

#include <span>
#include <string_view>

#include "gl/handle.h"
#include "gl/shader_source.h"

namespace ballpit::gl {

inline void delete_program(GLuint id) { glDeleteProgram(id); }

struct ShaderStage {
    GLenum kind = GL_COMPUTE_SHADER;  // or GL_VERTEX_SHADER, ...
    ShaderSource source;
};

class Program {
public:
    Program() = default;
    /// Compiles and links. Throws ShaderError with file, line and the driver's log.
    explicit Program(std::span<const ShaderStage> stages);

    void use() const { glUseProgram(handle_.id()); }
    GLuint id() const { return handle_.id(); }
    /// -1 for a uniform that is not active: glUniform* ignores it, as a permutation without it wants.
    GLint uniform(const char* name) const { return glGetUniformLocation(handle_.id(), name); }

private:
    Handle<delete_program> handle_;
};

}  // namespace ballpit::gl
