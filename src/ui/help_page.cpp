// F1: every key beside its meaning.
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
    ImGui::TableSetupColumn("meaning");
    return true;
}

}  // namespace

void help_page(const State&, Commands& commands) {
    if (begin_help_table("keys")) {
        for (const KeyRow& row : key_table()) {
            help_row(row.keys, row.meaning);
        }
        ImGui::EndTable();
    }
    ImGui::Spacing();
    ImGui::Separator();
    ImGui::Spacing();
    if (begin_help_table("camera")) {
        for (const CameraRow& row : camera_table()) {
            help_row(row.keys, row.meaning);
        }
        ImGui::EndTable();
    }
    ImGui::Spacing();
    if (key_button("Close##help", key_hint(Action::toggle_help), 7.0f * em(), true)) {
        commands.push_back(Action::toggle_help);
    }
}

}  // namespace ballpit::ui
