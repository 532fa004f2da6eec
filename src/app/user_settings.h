// What the window remembers from one day to the next, for each user: a JSON file that anybody may read, and the places
// of ImGui's windows beside it. A file that cannot be used costs a sentence, never the start.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "app/view_json.h"

namespace ballpit::app {

struct WindowPlace {
    int x = 0;  // points
    int y = 0;
    int width = 1280;
    int height = 720;
    friend bool operator==(const WindowPlace&, const WindowPlace&) = default;
};

struct UserSettings {
    std::optional<WindowPlace> place;  // where the window was before it filled the screen
    bool full_screen = false;
    double text_size = 1.0;
    double speed = 1.0;
    std::string backend = "auto";
    std::optional<Shown> shown;
    std::string scene;                           // name in the gallery, or a file; empty: none yet
    std::map<std::string, std::string> changed;  // settings of that scene that are not its own, as --set takes them
    std::optional<std::uint64_t> seed;           // where it is not the scene's
    std::string layout;                          // of ImGui's windows, as ImGui writes it

    friend bool operator==(const UserSettings&, const UserSettings&) = default;
};

struct LoadedSettings {
    UserSettings settings;  // the usual ones where there is no file, or none that can be used
    std::string message;    // one sentence for the screen; empty: nothing to tell
};

/// Reads settings.json and layout.ini of the folder. A file that is damaged or not ours is renamed to
/// settings.json.bad-<n>, and the message says so. Throws nothing of its own.
LoadedSettings load_user_settings(const std::filesystem::path& folder);

/// Writes both, each whole or not at all, and makes the folder. Throws InputError.
void save_user_settings(const std::filesystem::path& folder, const UserSettings& settings);

}  // namespace ballpit::app
