// Where a user's own files belong, by the rules of the system.
#pragma once

#include <filesystem>

namespace ballpit::app {

/// For settings: $XDG_CONFIG_HOME/ballpit, else ~/.config/ballpit; on Windows and macOS where SDL says. Empty where the
/// system names no such place. Not made by asking.
std::filesystem::path config_folder();

/// For files that a user saves where nothing else can be written: $XDG_DATA_HOME/ballpit, else ~/.local/share/ballpit.
std::filesystem::path data_folder();

}  // namespace ballpit::app
