// What a key or a button does, and the one table that names the keys: the input, the help page and the hints
// beside the controls all read it.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace ballpit::ui {

enum class Action : std::uint8_t {
    toggle_run,
    one_step,
    restart,
    new_seed,
    previous_scene,
    next_scene,
    toggle_occupancy,
    toggle_timings,
    toggle_laws,
    toggle_meters,
    toggle_budget,
    toggle_explorer,
    toggle_costs,
    shoot_ball,
    add_cluster,
    toggle_hand,
    toggle_shake,
    toggle_panels,
    full_screen,
    camera_home,
    toggle_help,
    share,
    save_scene,
    paste_code,
    forward,  // one unit
    back,
    forward_coarser,  // one of the next larger units
    back_coarser,
    step_start,
    step_end,
    unit_pass,
    unit_stage,
    unit_substep,
    unit_step,
    toggle_stepper,
    toggle_microscope,
    microscope_size,
    toggle_live_check,
    show_differences,
    toggle_follow,
    toggle_cells,
    toggle_buffers,
    toggle_split,
    toggle_contacts,
    toggle_arrows,
    toggle_slice,
    clear_selection,
    next_ball,
    previous_ball,
    layer_up,
    layer_down,
    slice_axis,
    next_colour,
    next_slot,
    close,  // what lies on top: a list, the help page, full screen; never the program
    quit,
};
inline constexpr std::size_t action_count = 56;

struct KeyRow {
    Action action;
    std::string_view keys;  // as printed on screen
    std::string_view hint;  // the first of them, for the space beside a control
    std::string_view meaning;
};

/// One row an action, in the order of the help page: first those of the window, then `stepping_actions` to look
/// inside a step.
std::span<const KeyRow> key_table();
inline constexpr std::size_t stepping_actions = 30;

/// The short form for the space beside a control.
std::string_view key_hint(Action action);

/// What moves the camera: held keys and the mouse, which are no actions.
struct CameraRow {
    std::string_view keys;
    std::string_view meaning;
};
std::span<const CameraRow> camera_table();

}  // namespace ballpit::ui
