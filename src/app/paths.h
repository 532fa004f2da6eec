// Where the program's own files are: beside the sources, beside the program, or installed.
#pragma once

#include <filesystem>

namespace ballpit::app {

struct Paths {
    std::filesystem::path shaders;  // glsl/
    std::filesystem::path assets;   // assets/
};

/// Looks in $BALLPIT_HOME, then upwards from the program's folder, then in share/ballpit beside it, then in the source
/// folder it was built from. Throws InputError that lists where it looked.
Paths find_paths();

}  // namespace ballpit::app
