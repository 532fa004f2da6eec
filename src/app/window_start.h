// What the window starts with.
#pragma once

#include <string>

#include "app/options.h"
#include "app/setup.h"
#include "app/user_settings.h"

namespace ballpit::app {

/// What the command line asks for; where it asks for nothing, the scene that was left last time, with its changes. If
/// that cannot come back, `message` says why. Throws InputError for what the command line asks for.
Setup make_window_setup(const Options& options, const UserSettings& user, std::string& message);

}  // namespace ballpit::app
