#include "app/user_folders.h"

#include <SDL_filesystem.h>
#include <SDL_stdinc.h>

#include <cstdlib>

namespace ballpit::app {

namespace {

namespace fs = std::filesystem;

#if defined(_WIN32) || defined(__APPLE__)
fs::path system_folder(const char*, const char*) {
    char* folder = SDL_GetPrefPath("", "Ball Pit");
    fs::path path = folder == nullptr ? fs::path() : fs::path(reinterpret_cast<const char8_t*>(folder));
    SDL_free(folder);
    return path;
}
#else
// The XDG base directory specification: a relative path counts as none.
fs::path system_folder(const char* variable, const char* below_home) {
    const char* named = std::getenv(variable);
    if (named != nullptr && fs::path(named).is_absolute()) {
        return fs::path(named) / "ballpit";
    }
    const char* home = std::getenv("HOME");
    return home != nullptr && fs::path(home).is_absolute() ? fs::path(home) / below_home / "ballpit" : fs::path();
}
#endif

}  // namespace

fs::path config_folder() { return system_folder("XDG_CONFIG_HOME", ".config"); }

fs::path data_folder() { return system_folder("XDG_DATA_HOME", ".local/share"); }

}  // namespace ballpit::app
