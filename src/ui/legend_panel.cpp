// What a colour means: a bar with numbers, or a square a meaning.
#include <algorithm>

#include "ui/probe_panels.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

constexpr float bar_width = 13.0f;  // em

void colour_bar(const Legend& legend) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = bar_width * em();
    const float height = 0.7f * em();
    ImDrawList* list = ImGui::GetWindowDrawList();
    const std::size_t pieces = legend.bar.size() - 1;
    for (std::size_t i = 0; i < pieces; ++i) {
        const float left = low.x + width * static_cast<float>(i) / static_cast<float>(pieces);
        const float right = low.x + width * static_cast<float>(i + 1) / static_cast<float>(pieces);
        const ImU32 a = packed(legend.bar[i]);
        const ImU32 b = packed(legend.bar[i + 1]);
        list->AddRectFilledMultiColor(ImVec2(left, low.y), ImVec2(right, low.y + height), a, b, b, a);
    }
    // From the right, where the unit stands: a label that would run into the next one is left out.
    float free_end = low.x + width;
    for (std::size_t i = legend.ticks.size(); i-- > 0;) {
        const LegendTick& tick = legend.ticks[i];
        const float x = low.x + width * tick.place;
        list->AddLine(ImVec2(x, low.y + height), ImVec2(x, low.y + height + 0.2f * em()), packed(text_colour));
        const float wide = ImGui::CalcTextSize(tick.text.c_str()).x;
        const float left = std::clamp(x - 0.5f * wide, low.x, std::max(low.x, low.x + width - wide));
        if (left + wide <= free_end) {
            list->AddText(ImVec2(left, low.y + height + 0.2f * em()), packed(dim_colour), tick.text.c_str());
            free_end = left - 0.4f * em();
        }
    }
    ImGui::Dummy(ImVec2(width, height + (legend.ticks.empty() ? 0.0f : 0.2f * em() + ImGui::GetTextLineHeight())));
}

void colour_square(const LegendEntry& entry) {
    const ImVec2 place = ImGui::GetCursorScreenPos();
    const float size = 0.7f * em();
    const float y = place.y + 0.5f * (ImGui::GetTextLineHeight() - size);
    ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(place.x, y), ImVec2(place.x + size, y + size),
                                              packed(entry.colour));
    ImGui::Dummy(ImVec2(size, size));
    ImGui::SameLine();
    dim_text(entry.text);
}

}  // namespace

void legend_panel(const Legend& legend) {
    text(legend.title);
    if (legend.bar.size() > 1) {
        colour_bar(legend);
    }
    for (const LegendEntry& entry : legend.entries) {
        colour_square(entry);
    }
}

}  // namespace ballpit::ui
