// The uniform block `params` of one program: just the constants that its permutation asks for, by name. The driver
// says where each lies.
#pragma once

#include <cstdint>
#include <vector>

#include "core/substep_params.h"
#include "gl/buffer.h"
#include "gl/program.h"

namespace ballpit::gpu {

class ParamsBlock {
public:
    /// No constants: bind() does nothing.
    ParamsBlock() = default;
    /// Throws gl::ShaderError if the program asks for a constant that there is none of, or of another type.
    explicit ParamsBlock(const gl::Program& program);

    /// Binds the block, with these values.
    void bind(const ShaderParams& params);
    std::size_t count() const { return fields_.size(); }
    std::size_t bytes() const { return bytes_.size(); }

private:
    struct Field {
        std::size_t offset;
        ShaderParam member;
    };

    std::vector<Field> fields_;
    std::vector<std::byte> bytes_;
    std::vector<std::byte> uploaded_;
    gl::Buffer buffer_;
};

}  // namespace ballpit::gpu
