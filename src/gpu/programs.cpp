#include "gpu/programs.h"

#include <array>
#include <string>

namespace ballpit::gpu {

std::vector<std::string_view> defines_of(Features features) {
    std::vector<std::string_view> defines;
    for (std::size_t bit = 0; bit < feature_defines.size(); ++bit) {
        if ((features.bits >> bit & 1u) != 0) {
            defines.push_back(feature_defines[bit]);
        }
    }
    return defines;
}

Programs::Compiled& Programs::get(const Program& program) {
    const auto found = compiled_.find(program);
    if (found != compiled_.end()) {
        return found->second;
    }
    const std::string file = std::string(shader_name(program.shader)) + ".comp";
    const std::array stages = {
        gl::ShaderStage{GL_COMPUTE_SHADER, gl::load_shader(folder_, file, defines_of(program.features))}};
    Compiled compiled;
    compiled.program = gl::Program(stages);
    compiled.params = ParamsBlock(compiled.program);
    compiled.dispatch_constants = compiled.program.uniform("dispatch_constants");
    return compiled_.emplace(program, std::move(compiled)).first->second;
}

}  // namespace ballpit::gpu
