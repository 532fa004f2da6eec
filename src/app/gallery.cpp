#include "app/gallery.h"

#include <algorithm>

#include "core/error.h"

namespace ballpit::app {

namespace fs = std::filesystem;

std::vector<SceneEntry> list_scenes(const fs::path& assets) {
    std::vector<SceneEntry> scenes;
    std::error_code error;
    for (const fs::directory_entry& file : fs::directory_iterator(assets / "scenes", error)) {
        if (file.path().extension() == ".json" && file.path().filename() != "scene.schema.json") {
            scenes.push_back({file.path().stem().string(), file.path()});
        }
    }
    if (scenes.empty()) {
        throw InputError((assets / "scenes").string() + ": expected at least one scene file (*.json)");
    }
    std::ranges::sort(scenes, {}, &SceneEntry::name);
    return scenes;
}

fs::path find_scene(const fs::path& assets, const std::string& name_or_file) {
    fs::path file(name_or_file);
    if (file.extension() == ".json" || file.has_parent_path()) {
        return file;
    }
    std::string names;
    for (const SceneEntry& scene : list_scenes(assets)) {
        if (scene.name == name_or_file) {
            return scene.path;
        }
        names += (names.empty() ? "" : ", ") + scene.name;
    }
    throw InputError("there is no scene '" + name_or_file + "': expected a file that ends in .json, or one of " +
                     names);
}

}  // namespace ballpit::app
