#include "ui/style.h"

namespace ballpit::ui {

namespace {

void set_colours(ImGuiStyle& style) {
    ImGui::StyleColorsDark(&style);
    const ImVec4 field{0.19f, 0.22f, 0.26f, 1.0f};
    const ImVec4 field_hovered{0.25f, 0.30f, 0.35f, 1.0f};
    const auto set = [&style](ImGuiCol which, const ImVec4& colour) { style.Colors[which] = colour; };
    set(ImGuiCol_Text, text_colour);
    set(ImGuiCol_TextDisabled, dim_colour);
    set(ImGuiCol_WindowBg, {0.07f, 0.085f, 0.10f, 0.90f});
    set(ImGuiCol_PopupBg, {0.09f, 0.11f, 0.13f, 0.98f});
    set(ImGuiCol_Border, {0.40f, 0.45f, 0.50f, 0.35f});
    set(ImGuiCol_FrameBg, field);
    set(ImGuiCol_FrameBgHovered, field_hovered);
    set(ImGuiCol_FrameBgActive, field_hovered);
    set(ImGuiCol_SliderGrab, {0.08f, 0.42f, 0.66f, 1.0f});  // values are written across it
    set(ImGuiCol_SliderGrabActive, {0.12f, 0.52f, 0.78f, 1.0f});
    set(ImGuiCol_CheckMark, {0.34f, 0.71f, 0.91f, 1.0f});
    set(ImGuiCol_Button, {0.23f, 0.27f, 0.32f, 1.0f});
    set(ImGuiCol_ButtonHovered, {0.30f, 0.36f, 0.42f, 1.0f});
    set(ImGuiCol_ButtonActive, accent_colour);
    set(ImGuiCol_Header, {0.15f, 0.18f, 0.21f, 1.0f});
    set(ImGuiCol_HeaderHovered, {0.22f, 0.27f, 0.32f, 1.0f});
    set(ImGuiCol_HeaderActive, accent_colour);
    set(ImGuiCol_Separator, {0.40f, 0.45f, 0.50f, 0.45f});
    set(ImGuiCol_TextSelectedBg, accent_colour);
}

}  // namespace

void apply_style(float scale) {
    ImGuiStyle style;  // from the defaults: scaling twice would add up
    set_colours(style);
    style.WindowRounding = 6.0f;
    style.FrameRounding = 4.0f;
    style.PopupRounding = 4.0f;
    style.GrabRounding = 3.0f;
    style.ScrollbarSize = 12.0f;
    style.GrabMinSize = 12.0f;
    style.WindowBorderSize = 1.0f;
    style.WindowPadding = {12.0f, 10.0f};
    style.FramePadding = {7.0f, 2.0f};
    style.ItemSpacing = {8.0f, 2.0f};
    style.CellPadding = {4.0f, 1.0f};
    style.ItemInnerSpacing = {6.0f, 4.0f};
    style.ScaleAllSizes(scale);
    ImGui::GetStyle() = style;
}

ImU32 packed(const vec3& srgb, float alpha) { return ImGui::ColorConvertFloat4ToU32({srgb.x, srgb.y, srgb.z, alpha}); }

}  // namespace ballpit::ui
