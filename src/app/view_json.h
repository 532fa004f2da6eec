// What is seen, as JSON: in the user's own settings and in share codes.
#pragma once

#include <nlohmann/json.hpp>

#include "core/json_document.h"
#include "ui/options.h"
#include "ui/probe.h"
#include "view/camera.h"

namespace ballpit::app {

/// Everything that the picture and its overlays are chosen by.
struct Shown {
    ui::ViewOptions view;
    ui::ProbeOptions probe;
    ui::LightOptions light;

    friend bool operator==(const Shown&, const Shown&) = default;
};

/// Only what differs from the defaults, so that a code stays short.
nlohmann::json shown_json(const Shown& shown);
/// Keys that are absent keep their defaults, keys that are unknown are passed over. Throws InputError with file and
/// JSON pointer for a value of another kind or out of its range.
Shown read_shown(const JsonValue& value);

/// [x, y, z, yaw, pitch, field of view]
nlohmann::json camera_json(const view::Camera& camera);
view::Camera read_camera(const JsonValue& value);

}  // namespace ballpit::app
