// F1: every key beside its meaning, in two columns.
#include "ui/panels.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

void help_row(std::string_view keys, std::string_view meaning) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    text(keys);
    ImGui::TableNextColumn();
    dim_text(meaning);
}

bool begin_help_table(const char* name) {
    if (!ImGui::BeginTable(name, 2, ImGuiTableFlags_SizingFixedFit)) {
        return false;
    }
    ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, 7.5f * em());
    ImGui::TableSetupColumn("meaning", ImGuiTableColumnFlags_WidthFixed, 20.5f * em());
    return true;
}

void action_rows(const char* name, std::span<const KeyRow> rows) {
    if (begin_help_table(name)) {
        for (const KeyRow& row : rows) {
            help_row(row.keys, row.meaning);
        }
        ImGui::EndTable();
    }
}

void rule() {
    ImGui::Spacing();
    ImGui::Separator();
    ImGui::Spacing();
}

void window_column() {
    action_rows("keys", key_table().first(key_table().size() - stepping_actions));
    rule();
    if (begin_help_table("camera")) {
        for (const CameraRow& row : camera_table()) {
            help_row(row.keys, row.meaning);
        }
        ImGui::EndTable();
    }
}

}  // namespace

void help_page(const State&, Commands& commands) {
    if (ImGui::BeginTable("columns", 2, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_BordersInnerV)) {
        for (const char* name : {"window", "inside a step"}) {
            ImGui::TableSetupColumn(name, ImGuiTableColumnFlags_WidthFixed, 29.0f * em());
        }
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        window_column();
        ImGui::TableNextColumn();
        action_rows("inside", key_table().last(stepping_actions));
        ImGui::EndTable();
    }
    ImGui::Spacing();
    if (key_button("Close##help", key_hint(Action::toggle_help), 7.0f * em(), true)) {
        commands.push_back(Action::toggle_help);
    }
}

}  // namespace ballpit::ui
