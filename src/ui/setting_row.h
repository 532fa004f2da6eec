// A row of the settings panel, made from a row of core's table: label, control with unit, reset button.
#pragma once

#include <string>

#include "core/settings.h"
#include "ui/state.h"

namespace ballpit::ui {

/// Ends of a slider, and whether it is logarithmic. Narrower than the setting's range where that spans more decades
/// than a slider can resolve; typing a value reaches the whole range.
struct SliderRange {
    double low;
    double high;
    bool logarithmic;
};
SliderRange slider_range(const SettingInfo& info, const Settings& defaults, std::uint32_t most_balls);

/// "m/s^2" as "m/s²"; a printf pattern that ends in a unit has its % doubled.
std::string shown_unit(std::string_view unit);

/// Whether the setting has a row in the settings panel: laws, walls in motion and hands have panels of their own.
bool has_row(const SettingInfo& info);

/// Appends the row; true when it has changed `edited`, whose value is then inside the setting's range.
bool setting_row(const SettingInfo& info, const State& state, Settings& edited);

}  // namespace ballpit::ui
