#include "ui/widgets.h"

#include <cstdarg>
#include <cstdio>

#include "ui/style.h"

namespace ballpit::ui {

void text(std::string_view words) { ImGui::TextUnformatted(words.data(), words.data() + words.size()); }

void dim_text(std::string_view words) {
    ImGui::PushStyleColor(ImGuiCol_Text, dim_colour);
    text(words);
    ImGui::PopStyleColor();
}

void wrapped_text(std::string_view words) {
    ImGui::PushTextWrapPos(0.0f);
    text(words);
    ImGui::PopTextWrapPos();
}

void wrapped_dim_text(std::string_view words) {
    ImGui::PushTextWrapPos(0.0f);
    dim_text(words);
    ImGui::PopTextWrapPos();
}

bool key_button(const char* label, std::string_view keys, float width, bool accent) {
    if (accent) {
        ImGui::PushStyleColor(ImGuiCol_Button, accent_colour);
    }
    ImGui::PushStyleVar(ImGuiStyleVar_ButtonTextAlign, ImVec2(0.0f, 0.5f));
    const bool pressed = ImGui::Button(label, ImVec2(width, 0.0f));
    ImGui::PopStyleVar();
    if (accent) {
        ImGui::PopStyleColor();
    }
    const float padding = ImGui::GetStyle().FramePadding.x;
    const ImVec2 size = ImGui::CalcTextSize(keys.data(), keys.data() + keys.size());
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    const ImVec2 place(high.x - padding - size.x, 0.5f * (low.y + high.y - size.y));
    ImGui::GetWindowDrawList()->AddText(place, packed(accent ? text_colour : dim_colour), keys.data(),
                                        keys.data() + keys.size());
    return pressed;
}

bool key_checkbox(const char* label, bool& value, std::string_view keys) {
    const bool changed = ImGui::Checkbox(label, &value);
    if (!keys.empty()) {
        ImGui::SameLine();
        dim_text(keys);
    }
    return changed;
}

float column_width(int columns) {
    const float spacing = ImGui::GetStyle().ItemSpacing.x;
    const float room = ImGui::GetContentRegionAvail().x - spacing * static_cast<float>(columns - 1);
    return room / static_cast<float>(columns);
}

bool section(const char* title, bool open) {
    ImGui::Spacing();
    return ImGui::CollapsingHeader(title, open ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None);
}

void row_label(std::string_view label, std::string_view about, float right) {
    ImGui::AlignTextToFramePadding();
    text(label);
    if (!about.empty()) {
        tooltip(about);
    }
    ImGui::SameLine(6.2f * em());
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - right);
}

void tooltip(std::string_view words) {
    if (!ImGui::IsItemHovered()) {
        return;
    }
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(18.0f * em());
    text(words);
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

std::string_view computer_text(std::string_view backend_name) {
    return backend_name == "gpu" ? "GPU" : backend_name == "threads" ? "CPU threads" : "CPU mirror";
}

std::string grouped(unsigned long long number) {
    std::string digits = std::to_string(number);
    for (std::size_t left = digits.size(); left > 3;) {
        left -= 3;
        digits.insert(left, "\u2009");
    }
    return digits;
}

std::string format(const char* pattern, ...) {
    char buffer[512];
    va_list values;
    va_start(values, pattern);
    std::vsnprintf(buffer, sizeof buffer, pattern, values);
    va_end(values);
    return buffer;
}

}  // namespace ballpit::ui
