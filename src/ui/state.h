// Everything that the panels read in a frame. The window fills it; the panels never change it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/extremes.h"
#include "core/features.h"
#include "core/layout.h"
#include "core/settings.h"
#include "measure/occupancy.h"
#include "ui/budget.h"
#include "ui/costs.h"
#include "ui/explorer.h"
#include "ui/inspection.h"
#include "ui/laws.h"
#include "ui/meters.h"
#include "ui/options.h"
#include "ui/play.h"
#include "ui/probe.h"
#include "ui/share.h"
#include "ui/stepping.h"

namespace ballpit::ui {

struct SceneChoice {
    std::string name;
    std::string about;
};

/// A stage of the frame. Times are means over a quarter of a second, so that they can be read.
struct TimingRow {
    std::string_view name;
    std::string_view per;  // what one time is for: "substep" or "frame"
    vec3 colour{1.0f};     // sRGB
    double now_ms = 0.0;
    double median_ms = 0.0;
    std::span<const float> history;  // ms, oldest first
};

struct State {
    std::span<const SceneChoice> scenes;
    std::size_t scene = 0;

    bool running = false;
    double time = 0.0;  // s since the start
    std::uint64_t step_count = 0;
    std::uint64_t seed = 0;
    double speed = 1.0;     // simulated seconds a second, as asked for
    double achieved = 0.0;  // the same, as it turned out; 0 while not running

    Settings settings;
    Settings defaults;  // the scene's own
    Features features;
    Variety variety;
    bool own_restitutions = false;             // some ball of the scene has one
    std::uint32_t most_balls = maximum_balls;  // what the scene can give
    std::uint32_t overlapping = 0;             // balls that found no free place at the start

    BackendChoice backend = BackendChoice::automatic;
    bool software = false;  // a CPU draws: where there is no GPU
    bool gpu_usable = true;
    std::string_view backend_name;  // of the one that computes: "gpu", "cpu" or "threads"
    std::string_view device;

    ViewOptions view;
    LightOptions light;
    float text_size = 1.0f;
    bool full_screen = false;

    double fps = 0.0;
    double frame_ms = 0.0;
    std::span<const TimingRow> timings;

    Status status{};
    ExtremeNumbers extremes;  // without those that were hidden
    bool has_grid = true;
    double cell_width = 0.0;                        // m
    double largest_radius = 0.0;                    // m
    const measure::Occupancy* occupancy = nullptr;  // null until the first copy has arrived
    std::uint32_t top_count = 8;                    // balls in a cell that get the last colour
    vec3 (*which_colour)(std::uint32_t) = nullptr;  // sRGB of a ball, as the picture tints it
    vec3 (*amount_colour)(float) = nullptr;         // sRGB of an amount from 0 to 1, as the picture colours cells

    const SteppingState* stepping = nullptr;  // never null in the window
    const Inspection* inspection = nullptr;   // null while no panel looks into the buffers
    const ProbeState* probe = nullptr;        // never null in the window
    const PlayState* play = nullptr;          // never null in the window
    const LawsState* laws = nullptr;          // null while their window is closed
    const BudgetState* budget = nullptr;      // the same
    const ExplorerState* explorer = nullptr;  // the same
    const CostsState* costs = nullptr;        // the same

    const MetersState* meters = nullptr;  // null while their window is closed

    const ShareState* share = nullptr;  // never null in the window

    std::string_view message;  // empty: none
    bool close_popups = false;
};

}  // namespace ballpit::ui
