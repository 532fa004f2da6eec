// Where the time goes: a row a stage with now, median and history.
#include <algorithm>

#include "ui/panels.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

void right_aligned(const std::string& words) {
    const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(words.c_str()).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, room));
    text(words);
}

std::string milliseconds(double ms) {
    return ms >= 100.0  ? format("%.0f", ms)
           : ms >= 10.0 ? format("%.1f", ms)
           : ms >= 1.0  ? format("%.2f", ms)
                        : format("%.3f", ms);
}

// Bars from the newest at the right edge to the oldest; the top is the largest value of the row itself.
void history_plot(const TimingRow& row, ImVec2 size) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 high(low.x + size.x, low.y + size.y);
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddRectFilled(low, high, packed(vec3(0.15f, 0.18f, 0.21f)));
    const auto pixels = static_cast<std::size_t>(size.x);
    const std::size_t shown = std::min(row.history.size(), pixels);
    const auto recent = row.history.last(shown);
    const float top = shown == 0 ? 0.0f : *std::ranges::max_element(recent);
    for (std::size_t i = 0; i < shown && top > 0.0f; ++i) {
        const float x = high.x - static_cast<float>(shown - i);
        const float height = std::max(1.0f, recent[i] / top * size.y);
        list->AddRectFilled(ImVec2(x, high.y - height), ImVec2(x + 1.0f, high.y), packed(row.colour));
    }
    ImGui::Dummy(size);
    if (top > 0.0f) {
        tooltip("Newest at the right; the top is " + milliseconds(static_cast<double>(top)) + " ms.");
    }
}

void timing_row(const TimingRow& row) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const float size = 0.7f * em();
    const ImVec2 place = ImGui::GetCursorScreenPos();
    const float y = place.y + 0.5f * (ImGui::GetTextLineHeight() - size);
    ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(place.x, y), ImVec2(place.x + size, y + size), packed(row.colour));
    ImGui::Dummy(ImVec2(size, size));
    ImGui::SameLine();
    text(row.name);
    const bool known = !row.history.empty();
    ImGui::TableNextColumn();
    right_aligned(known ? milliseconds(row.now_ms) : "–");
    ImGui::TableNextColumn();
    right_aligned(known ? milliseconds(row.median_ms) : "–");
    ImGui::TableNextColumn();
    dim_text(row.per);
    ImGui::TableNextColumn();
    history_plot(row, ImVec2(10.0f * em(), ImGui::GetTextLineHeight()));
}

}  // namespace

void timings_panel(const State& state) {
    text("Stage timings");
    ImGui::SameLine();
    dim_text(key_hint(Action::toggle_timings));
    if (!ImGui::BeginTable("timings", 5, ImGuiTableFlags_SizingFixedFit)) {
        return;
    }
    ImGui::TableSetupColumn("stage", ImGuiTableColumnFlags_WidthFixed, 7.6f * em());
    ImGui::TableSetupColumn("now", ImGuiTableColumnFlags_WidthFixed, 3.2f * em());
    ImGui::TableSetupColumn("median", ImGuiTableColumnFlags_WidthFixed, 3.6f * em());
    ImGui::TableSetupColumn("per", ImGuiTableColumnFlags_WidthFixed, 4.2f * em());
    ImGui::TableSetupColumn("history", ImGuiTableColumnFlags_WidthFixed, 10.0f * em());
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    dim_text("stage");
    for (const char* heading : {"now", "median"}) {
        ImGui::TableNextColumn();
        ImGui::PushStyleColor(ImGuiCol_Text, dim_colour);
        right_aligned(heading);
        ImGui::PopStyleColor();
    }
    ImGui::TableNextColumn();
    dim_text("ms a");
    ImGui::TableNextColumn();
    dim_text("history");
    for (const TimingRow& row : state.timings) {
        timing_row(row);
    }
    ImGui::EndTable();
}

}  // namespace ballpit::ui
