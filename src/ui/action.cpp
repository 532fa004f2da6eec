#include "ui/action.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace ballpit::ui {

namespace {

constexpr std::array<KeyRow, action_count> keys = {{
    {Action::toggle_run, "Space, P", "Space", "Run or pause"},
    {Action::one_step, "O, Enter", "O", "One step, then pause"},
    {Action::restart, "R", "R", "Restart with the same seed: the same run again"},
    {Action::new_seed, "Shift+R", "Shift+R", "Restart with a new seed"},
    {Action::previous_scene, "[", "[", "Previous scene"},
    {Action::next_scene, "]", "]", "Next scene"},
    {Action::shoot_ball, "B", "B", "Shoot a ball from the eye towards the pointer"},
    {Action::add_cluster, "N", "N", "Add a cluster of balls before the eye"},
    {Action::toggle_hand, "H", "H", "Hand: drag a wall, pull a ball"},
    {Action::toggle_shake, "Z", "Z", "Shake the box"},
    {Action::toggle_occupancy, "G", "G", "Occupied cells and how many balls they hold"},
    {Action::toggle_timings, "F3", "F3", "Time of every stage"},
    {Action::toggle_laws, "F4", "F4", "Laws of this scene, and what they cost"},
    {Action::toggle_meters, "F6", "F6", "Meters: where the energy goes, and how stable it is"},
    {Action::toggle_budget, "F7", "F7", "Error budget: how much may be wrong, and the substeps for it"},
    {Action::toggle_explorer, "F8", "F8", "Speed against accuracy, measured for this scene"},
    {Action::toggle_costs, "F9", "F9", "Cost against the number of balls, measured for this scene"},
    {Action::toggle_panels, "Tab", "Tab", "Hide or show the panels"},
    {Action::full_screen, "F11", "F11", "Full screen"},
    {Action::camera_home, "Home", "Home", "Camera back to its place"},
    {Action::share, "F", "F", "Share this moment: a code to copy"},
    {Action::paste_code, "Ctrl+V", "Ctrl+V", "Open the code that was copied"},
    {Action::save_scene, "Ctrl+S", "Ctrl+S", "Save this moment as a scene file"},
    {Action::toggle_help, "F1", "F1", "This page"},
    {Action::close, "Esc", "Esc", "Close a list, this page or full screen"},
    {Action::quit, "Ctrl+Q", "Ctrl+Q", "Quit"},
    {Action::forward, "→, PgDn", "→", "One unit forth, then pause"},
    {Action::back, "←, PgUp", "←", "One unit back"},
    {Action::forward_coarser, "Shift+→", "Shift+→", "One of the next larger units forth"},
    {Action::back_coarser, "Shift+←", "Shift+←", "One of the next larger units back"},
    {Action::step_start, "Ctrl+Home", "Ctrl+Home", "To the start of the step"},
    {Action::step_end, "Ctrl+End", "Ctrl+End", "To the end of the step"},
    {Action::unit_pass, "1", "1", "Unit: a pass (one dispatch)"},
    {Action::unit_stage, "2", "2", "Unit: a stage"},
    {Action::unit_substep, "3", "3", "Unit: a substep"},
    {Action::unit_step, "4", "4", "Unit: a step"},
    {Action::toggle_stepper, "F2", "F2", "The strip of dispatches, to look inside a step"},
    {Action::toggle_microscope, "M", "M", "Microscope of the bitonic sort"},
    {Action::microscope_size, "Shift+M", "Shift+M", "It shows 16, 64 or all slots"},
    {Action::toggle_live_check, "K", "K", "Check every stage against the mirror"},
    {Action::show_differences, "J", "J", "What the check found, stage by stage"},
    {Action::toggle_follow, "T", "T", "Follow one ball: click it"},
    {Action::toggle_cells, "C", "C", "Table of the cells"},
    {Action::toggle_buffers, "U", "U", "Tables of all buffers"},
    {Action::toggle_split, "X", "X", "Brute force beside the grid"},
    {Action::toggle_contacts, "I", "I", "Contacts as lines, coloured by overlap"},
    {Action::toggle_arrows, "V", "V", "Velocity arrows"},
    {Action::next_colour, "Shift+V", "Shift+V", "What the colour of a ball tells: the next choice"},
    {Action::toggle_slice, "L", "L", "A layer of the grid as a heat map"},
    {Action::next_ball, ".", ".", "Follow the next ball"},
    {Action::previous_ball, ",", ",", "Follow the ball before"},
    {Action::slice_axis, "Shift+L", "Shift+L", "The layer across another axis"},
    {Action::layer_up, "↑", "↑", "The next layer"},
    {Action::layer_down, "↓", "↓", "The layer before"},
    {Action::next_slot, "Shift+U", "Shift+U", "The next buffer"},
    {Action::clear_selection, "Delete", "Del", "Forget the selected ball and cell"},
}};

constexpr std::array<CameraRow, 7> camera = {{
    {"W  A  S  D", "Forward, left, back, right"},
    {"E  Q", "Up, down"},
    {"Shift", "Move faster while held"},
    {"Drag", "Look around"},
    {"Right drag", "Move sideways and up"},
    {"Wheel", "Nearer, farther"},
    {"Ctrl+click", "Type a slider's value"},
}};

}  // namespace

std::span<const KeyRow> key_table() { return keys; }

std::string_view key_hint(Action action) {
    const auto row = std::ranges::find(keys, action, &KeyRow::action);
    assert(row != keys.end());
    return row->hint;
}

std::span<const CameraRow> camera_table() { return camera; }

}  // namespace ballpit::ui
