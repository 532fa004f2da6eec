// The scenes that can be picked by name.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/scene.h"

namespace ballpit::app {

struct SceneEntry {
    std::string name;  // file stem, as on the command line
    std::filesystem::path path;
};

/// assets/scenes/*.json, by name; not the schema that lies beside them.
std::vector<SceneEntry> list_scenes(const std::filesystem::path& assets);

/// A scene of the gallery by name, or any file that ends in .json or has a path separator. Throws InputError that
/// lists the names if there is none.
std::filesystem::path find_scene(const std::filesystem::path& assets, const std::string& name_or_file);

}  // namespace ballpit::app
