// Programs that draw the balls one by one, in the variants that pictures ask for.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "gl/program.h"

namespace ballpit::view {

/// Without and with what only some pictures ask for, so that the others do not pay. Throws gl::ShaderError.
struct BallPrograms {
    BallPrograms(const std::filesystem::path& shader_folder, const std::string& stem,
                 std::vector<std::string_view> defines = {});
    gl::Program whole;
    gl::Program faded;  // some balls see-through or left out
};

/// Of one look, for balls coloured as such or by value.
struct LookPrograms {
    LookPrograms(const std::filesystem::path& shader_folder, const std::string& stem);
    BallPrograms usual;
    BallPrograms valued;
    gl::Program listed;  // the balls that PixelBalls lists
    gl::Program listed_valued;
};

}  // namespace ballpit::view
