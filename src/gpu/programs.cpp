#include "gpu/programs.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <string>

#include "core/stopwatch.h"

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

namespace {

// Where the state is kept is no law.
bool same_laws(const Program& a, const Program& b) {
    const auto laws = [](Features features) {
        return features.without(Feature::sorted_copies).without(Feature::kept_order);
    };
    return laws(a.features) == laws(b.features);
}

}  // namespace

Programs::Compiled& Programs::get(const Program& program) {
    const auto found = compiled_.find(program);
    if (found != compiled_.end()) {
        return found->second;
    }
    const auto start = std::chrono::steady_clock::now();
    const std::string file = std::string(shader_name(program.shader)) + ".comp";
    const std::array stages = {
        gl::ShaderStage{GL_COMPUTE_SHADER, gl::load_shader(folder_, file, defines_of(program.features))}};
    Compiled compiled;
    compiled.program = gl::Program(stages);
    compiled.params = ParamsBlock(compiled.program);
    compiled.dispatch_constants = compiled.program.uniform("dispatch_constants");
    const bool known = std::ranges::any_of(
        shipped_, [&](const Program& each) { return each.shader == program.shader && same_laws(each, program); });
    if (!shipped_.empty() && program.shader == Shader::collide && !known) {
        on_demand_.push_back({program, milliseconds_since(start)});
    }
    return compiled_.emplace(program, std::move(compiled)).first->second;
}

bool Programs::build_one() {
    const auto missing =
        std::ranges::find_if(shipped_, [this](const Program& program) { return !compiled_.contains(program); });
    if (missing == shipped_.end()) {
        return false;
    }
    get(*missing);
    return true;
}

}  // namespace ballpit::gpu
