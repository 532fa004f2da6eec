// Compiled programs, without data: changing the scene keeps them. Each permutation is compiled when it is first
// asked for.
#pragma once

#include <filesystem>
#include <map>

#include "core/schedule.h"
#include "gl/program.h"
#include "gpu/params_block.h"

namespace ballpit::gpu {

class Programs {
public:
    explicit Programs(std::filesystem::path shader_folder) : folder_(std::move(shader_folder)) {}

    struct Compiled {
        gl::Program program;
        ParamsBlock params;
        GLint dispatch_constants = -1;  // uniform location
    };

    /// Throws gl::ShaderError with file, line and the driver's log.
    Compiled& get(const Program& program);

private:
    std::filesystem::path folder_;
    std::map<Program, Compiled> compiled_;
};

/// The #defines of a permutation.
std::vector<std::string_view> defines_of(Features features);

}  // namespace ballpit::gpu
