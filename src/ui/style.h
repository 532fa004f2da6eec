// Colours and measures of the panels: light on dark, high contrast, and no meaning carried by hue alone.
#pragma once

#include <imgui.h>

#include "core/vector.h"

namespace ballpit::ui {

inline const ImVec4 text_colour{0.96f, 0.97f, 0.98f, 1.0f};
inline const ImVec4 dim_colour{0.66f, 0.71f, 0.77f, 1.0f};
inline const ImVec4 accent_colour{0.00f, 0.40f, 0.64f, 1.0f};   // a darkened Okabe-Ito blue: white text on it reads
inline const ImVec4 notice_colour{0.36f, 0.25f, 0.00f, 0.96f};  // behind a message
inline const ImVec4 alarm_colour{0.60f, 0.09f, 0.02f, 0.96f};   // behind a failure

/// Font height in pixels at scale 1, which is a window 720 points high: a fortieth of the height.
inline constexpr float font_height = 17.0f;

/// Sets ImGui's style for this scale (points); may be called again when the scale changes.
void apply_style(float scale);

/// Height of a line of text: every measure of the panels is a multiple of it.
inline float em() { return ImGui::GetFontSize(); }

ImU32 packed(const vec3& srgb, float alpha = 1.0f);
inline ImU32 packed(const ImVec4& colour) { return ImGui::ColorConvertFloat4ToU32(colour); }

}  // namespace ballpit::ui
