// What the windows share that measure beside the run, on a backend of their own, a slice a frame.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/window_session.h"

namespace ballpit::app {

/// What a measurement holds for: where none of it has changed, it still does.
struct MeasuredRun {
    Settings settings;  // but for those that the measurement itself varies
    int scene_changes = 0;
    std::string backend;
    friend bool operator==(const MeasuredRun&, const MeasuredRun&) = default;
};

/// The run of the session with these settings. What a hand does to a ball for a moment makes it no other one.
MeasuredRun measured_run(const Session& session, Settings settings);

/// Carries out what needs a device, which may fail where the run itself goes on: then the sentence that tells why.
std::optional<std::string> device_failure(const std::function<void()>& work);

}  // namespace ballpit::app
