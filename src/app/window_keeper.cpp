#include "app/window_keeper.h"

#include "core/error.h"

namespace ballpit::app {

namespace {

constexpr double pause_s = 4.0;  // between two writings

}  // namespace

bool Keeper::due(double now_s) const { return now_s - written_s_ >= pause_s; }

void Keeper::update(UserSettings settings, double now_s) {
    written_s_ = now_s;
    write(std::move(settings));
}

void Keeper::finish(UserSettings settings) { write(std::move(settings)); }

void Keeper::write(UserSettings settings) {
    if (failed_ || settings == kept_) {
        return;
    }
    try {
        save_user_settings(folder_, settings);
        kept_ = std::move(settings);
    } catch (const InputError& error) {
        failed_ = true;
        message_ = "Settings are not kept: " + std::string(error.what());
    }
}

}  // namespace ballpit::app
