// Reads GLSL files: resolves #include "…" (GLSL has none of its own), puts in the #defines of a permutation, and
// remembers which file each piece of text came from, so that the driver's log can name file and line.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ballpit::gl {

struct ShaderSource {
    std::string text;                          // what the compiler gets
    std::vector<std::filesystem::path> files;  // source-string number of #line -> file
    std::string name;                          // file name, and the defines it was read with
};

/// Reads `file` below `folder`; #include paths are below `folder` too, each included once. The #version line
/// must come first; the defines follow it. Throws ShaderError that names file and line where a file is
/// missing or an #include is not understood.
ShaderSource load_shader(const std::filesystem::path& folder, const std::string& file,
                         const std::vector<std::string_view>& defines = {});

/// The driver's log with source-string numbers replaced by file names. Drivers write them as 0:12(5) (Mesa),
/// 0(12) (NVIDIA) or 0:12: (AMD, Intel, Apple).
std::string readable_log(const ShaderSource& source, const std::string& log);

}  // namespace ballpit::gl
