// Programs of the drawing shaders.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "gl/program.h"

namespace ballpit::view {

/// <stem>.vert and <stem>.frag of the folder, linked, with frame block and textures at their places. Throws
/// gl::ShaderError.
gl::Program load_view_program(const std::filesystem::path& shader_folder, const std::string& stem,
                              const std::vector<std::string_view>& defines = {});

/// The same of <stem>.comp. Needs OpenGL 4.3.
gl::Program load_compute_program(const std::filesystem::path& shader_folder, const std::string& stem,
                                 const std::vector<std::string_view>& defines = {});

}  // namespace ballpit::view
