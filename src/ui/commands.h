// What the panels and keys ask for. Panels only append; the window's loop carries them out in one place.
#pragma once

#include <cstddef>
#include <variant>
#include <vector>

#include "core/settings.h"
#include "ui/action.h"
#include "ui/options.h"

namespace ballpit::ui {

/// Every value of the scene that is running; only what differs is applied.
struct ChangeSettings {
    Settings settings;
};
/// Index into State::scenes.
struct ChooseScene {
    std::size_t index;
};
struct ChooseBackend {
    BackendChoice choice;
};
/// Simulated seconds a second of wall time.
struct ChangeSpeed {
    double speed;
};
struct ChangeView {
    ViewOptions view;
};
struct ChangeLight {
    LightOptions light;
};
/// Factor on the size that the window's height gives.
struct ChangeTextSize {
    float factor;
};
/// Forget the failures counted so far.
struct ClearStatus {};
struct DismissMessage {};

using Command = std::variant<Action, ChangeSettings, ChooseScene, ChooseBackend, ChangeSpeed, ChangeView, ChangeLight,
                             ChangeTextSize, ClearStatus, DismissMessage>;
using Commands = std::vector<Command>;

}  // namespace ballpit::ui
