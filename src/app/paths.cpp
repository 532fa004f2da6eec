#include "app/paths.h"

#include <SDL_filesystem.h>
#include <SDL_stdinc.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "core/error.h"

namespace ballpit::app {

namespace {

namespace fs = std::filesystem;

fs::path program_folder() {
    char* base = SDL_GetBasePath();
    const fs::path folder = base == nullptr ? fs::current_path() : fs::path(base);
    SDL_free(base);
    return folder.lexically_normal();
}

std::vector<fs::path> candidates() {
    if (const char* home = std::getenv("BALLPIT_HOME")) {
        return {home};  // whoever sets it means it: no other place stands in for it
    }
    std::vector<fs::path> folders;
    fs::path folder = program_folder();
    for (int up = 0; up < 4 && !folder.empty(); ++up) {
        folders.push_back(folder);
        folders.push_back(folder / "share" / "ballpit");
        folder = folder.parent_path();
    }
    folders.emplace_back(BALLPIT_SOURCE_FOLDER);
    return folders;
}

}  // namespace

Paths find_paths() {
    std::string looked;
    for (const fs::path& folder : candidates()) {
        if (fs::is_directory(folder / "glsl") && fs::is_directory(folder / "assets")) {
            return {folder / "glsl", folder / "assets"};
        }
        looked += (looked.empty() ? "" : ", ") + folder.string();
    }
    throw InputError("cannot find the folders glsl and assets: expected both in one of " + looked);
}

}  // namespace ballpit::app
