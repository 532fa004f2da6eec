// Scene files: JSON text to a Scene. docs/scenes.md is the reference of the format.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/scene.h"

namespace ballpit {

/// The scene that the text describes. Throws InputError in one sentence that names `file`, the place (line and
/// column of broken JSON, else the JSON pointer), what was expected there and what was found.
Scene parse_scene(std::string_view text, const std::string& file);

/// Reads the file and parses it. Throws InputError also for a file that cannot be read or exceeds 1 GiB.
Scene load_scene(const std::filesystem::path& path);

}  // namespace ballpit
