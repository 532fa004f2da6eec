#include "gpu/params_block.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string>

#include "gl/error.h"

namespace ballpit::gpu {

namespace {

GLenum gl_type(const ShaderParam& member) {
    constexpr std::array<GLenum, std::variant_size_v<ShaderParam>> types = {GL_FLOAT, GL_UNSIGNED_INT, GL_FLOAT_VEC3,
                                                                            GL_UNSIGNED_INT_VEC3};
    return types.at(member.index());
}

std::string uniform_name(GLuint program, GLuint uniform) {
    std::array<char, 128> name{};
    GLsizei length = 0;
    glGetActiveUniformName(program, uniform, name.size(), &length, name.data());
    return {name.data(), static_cast<std::size_t>(length)};
}

// "ParamsBlock.gain" or "params.gain": drivers differ in whose name they put first.
std::string_view member_name(std::string_view uniform) { return uniform.substr(uniform.rfind('.') + 1); }

}  // namespace

ParamsBlock::ParamsBlock(const gl::Program& program) {
    const GLuint block = glGetUniformBlockIndex(program.id(), "ParamsBlock");
    if (block == GL_INVALID_INDEX) {
        return;
    }
    GLint size = 0;
    GLint count = 0;
    glGetActiveUniformBlockiv(program.id(), block, GL_UNIFORM_BLOCK_DATA_SIZE, &size);
    glGetActiveUniformBlockiv(program.id(), block, GL_UNIFORM_BLOCK_ACTIVE_UNIFORMS, &count);
    std::vector<GLint> uniforms(static_cast<std::size_t>(count));
    glGetActiveUniformBlockiv(program.id(), block, GL_UNIFORM_BLOCK_ACTIVE_UNIFORM_INDICES, uniforms.data());
    for (const GLint uniform : uniforms) {
        const auto index = static_cast<GLuint>(uniform);
        GLint offset = 0;
        GLint type = 0;
        glGetActiveUniformsiv(program.id(), 1, &index, GL_UNIFORM_OFFSET, &offset);
        glGetActiveUniformsiv(program.id(), 1, &index, GL_UNIFORM_TYPE, &type);
        const std::string name = uniform_name(program.id(), index);
        const auto found = std::ranges::find(shader_param_table(), member_name(name), &ShaderParamInfo::name);
        if (found == shader_param_table().end() || gl_type(found->member) != static_cast<GLenum>(type)) {
            throw gl::ShaderError(
                "uniform '" + name +
                "' is none of the constants of a substep, by name and type (core/substep_params.cpp)");
        }
        fields_.push_back({static_cast<std::size_t>(offset), found->member});
    }
    bytes_.resize(static_cast<std::size_t>(size));
    buffer_ = gl::Buffer("params", bytes_.size(), GL_DYNAMIC_DRAW);
}

void ParamsBlock::bind(const ShaderParams& params) {
    if (bytes_.empty()) {
        return;
    }
    for (const Field& field : fields_) {
        std::visit(
            [&](auto member) { std::memcpy(bytes_.data() + field.offset, &(params.*member), sizeof(params.*member)); },
            field.member);
    }
    if (bytes_ != uploaded_) {
        buffer_.write(bytes_);
        uploaded_ = bytes_;
    }
    buffer_.bind_base(GL_UNIFORM_BUFFER, BLOCK_PARAMS);
}

}  // namespace ballpit::gpu
