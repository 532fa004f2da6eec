// Keeps what the window remembers on disk: a while after it changed, and at the end.
#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include "app/user_settings.h"

namespace ballpit::app {

class Keeper {
public:
    Keeper(std::filesystem::path folder, UserSettings kept) : folder_(std::move(folder)), kept_(std::move(kept)) {}

    /// Whether it is time for another look at what changed: a slider that moves is not a file a frame.
    bool due(double now_s) const;
    /// `now_s` of the window's clock.
    void update(UserSettings settings, double now_s);
    /// At the end. What cannot be written then is not told any more.
    void finish(UserSettings settings);

    std::string take_message() { return std::exchange(message_, {}); }

private:
    void write(UserSettings settings);

    std::filesystem::path folder_;
    UserSettings kept_;
    double written_s_ = 0.0;
    bool failed_ = false;  // it is told once, and not tried again
    std::string message_;
};

}  // namespace ballpit::app
