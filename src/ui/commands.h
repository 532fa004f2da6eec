// What the panels and keys ask for. Panels only append; the window's loop carries them out in one place.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/settings.h"
#include "measure/sweep.h"
#include "ui/action.h"
#include "ui/budget.h"
#include "ui/options.h"
#include "ui/play.h"
#include "ui/probe.h"
#include "ui/stepping.h"

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
/// No more of what is warned of now.
struct HideWarnings {};
/// Pushes balls that overlap apart, before anything else moves.
struct RelaxOverlaps {};
struct DismissMessage {};
/// What each law costs, measured anew.
struct MeasureLaws {};
/// The balance of the energy begins anew.
struct RestartMeters {};
struct ChangeBudget {
    BudgetOptions options;
};
/// What each choice of substeps, integrator and precision costs and how exact it is, measured from the start.
struct StartSweep {};
struct StopSweep {};
struct ChooseMetric {
    measure::SweepMetric metric;
};
/// What a substep costs with other numbers of balls and every sort.
struct StartCosts {};
struct StopCosts {};
struct ChangePlay {
    PlayOptions options;
};

/// What the arrow keys move by.
struct ChooseUnit {
    StepUnit unit;
};
struct StepForward {
    StepUnit unit;
};
struct StepBack {
    StepUnit unit;
};
/// To a place that was reached before or lies ahead.
struct GoTo {
    Place place;
};
struct SetCheckpointBudget {
    std::size_t bytes;
};
struct SetLiveCheck {
    LiveCheckMode mode;
};
/// The table of what backend and mirror have left differently; without a stage it closes.
struct ShowDifferences {
    std::optional<Stage> stage;
};
/// The ball that is marked and followed; the camera flies to it if asked to.
struct SelectBall {
    std::optional<std::uint32_t> ball;
    bool fly = false;
};
struct SelectCell {
    std::optional<std::uint32_t> cell;
};

struct ChangeProbe {
    ProbeOptions options;
};
/// The cell that a ball is in, as the copies of the buffers have it.
struct SelectCellOfBall {
    std::uint32_t ball;
};
/// Opens the buffer tables at an element.
struct ShowElement {
    Slot slot;
    std::uint64_t element;
};
/// Writes the copy of a slot as CSV.
struct ExportSlot {
    Slot slot;
};

/// The share code that the panel shows, to the clipboard.
struct CopyCode {};
/// What Ctrl+S saves under, without a folder.
struct NameFile {
    std::string name;
};

using Command = std::variant<Action, ChangeSettings, ChooseScene, ChooseBackend, ChangeSpeed, ChangeView, ChangeLight,
                             ChangeTextSize, ClearStatus, DismissMessage, ChooseUnit, StepForward, StepBack, GoTo,
                             SetCheckpointBudget, SetLiveCheck, ShowDifferences, SelectBall, SelectCell, ChangeProbe,
                             SelectCellOfBall, ShowElement, ExportSlot, CopyCode, NameFile, MeasureLaws, ChangeBudget,
                             ChangePlay, RestartMeters, HideWarnings, RelaxOverlaps, StartSweep, StopSweep,
                             ChooseMetric, StartCosts, StopCosts>;
using Commands = std::vector<Command>;

}  // namespace ballpit::ui
