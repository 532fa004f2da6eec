// Every setting that does anything in this scene, and what computes it.
#include <string>

#include "ui/panels.h"
#include "ui/setting_row.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

const char* backend_text(BackendChoice choice) {
    switch (choice) {
        case BackendChoice::gpu:
            return "GPU";
        case BackendChoice::cpu:
            return "CPU mirror";
        case BackendChoice::automatic:
            break;
    }
    return "auto";
}

std::string backend_preview(const State& state) {
    std::string shown = backend_text(state.backend);
    if (state.backend == BackendChoice::automatic) {
        shown += state.backend_name == "gpu" ? ": GPU" : ": CPU mirror";
    }
    return shown;
}

void backend_row(const State& state, Commands& commands) {
    const float button = ImGui::GetFrameHeight();
    row_label("Backend", "What computes the balls: the GPU, or the same stages one after the other on the CPU.",
              button + ImGui::GetStyle().ItemInnerSpacing.x);
    if (!ImGui::BeginCombo("##backend", backend_preview(state).c_str())) {
        return;
    }
    if (state.close_popups) {
        ImGui::CloseCurrentPopup();
    }
    for (std::size_t i = 0; i < backend_choice_names.size(); ++i) {
        const auto choice = static_cast<BackendChoice>(i);
        const bool usable = choice != BackendChoice::gpu || state.gpu_usable;
        const auto flags = usable ? ImGuiSelectableFlags_None : ImGuiSelectableFlags_Disabled;
        if (ImGui::Selectable(usable ? backend_text(choice) : "GPU (needs OpenGL 4.3)", choice == state.backend,
                              flags)) {
            commands.push_back(ChooseBackend{choice});
        }
    }
    ImGui::EndCombo();
}

}  // namespace

void settings_panel(const State& state, Commands& commands) {
    if (!section("Settings", true)) {
        return;
    }
    Settings edited = state.settings;
    bool changed = false;
    for (const SettingInfo& info : setting_table()) {
        if (has_row(info) && setting_applies(info, state.settings.laws)) {
            changed |= setting_row(info, state, edited);
        }
    }
    if (changed) {
        commands.push_back(ChangeSettings{edited});
    }
    backend_row(state, commands);
}

}  // namespace ballpit::ui
