// Every setting that does anything in this scene: first what is modelled and how exactly, then what it is computed
// with.
#include <algorithm>
#include <array>
#include <string>

#include "core/grid_reuse.h"
#include "core/text.h"
#include "ui/panels.h"
#include "ui/setting_row.h"
#include "ui/stage_sentence.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

// What no result depends on, unless it is chosen badly.
constexpr std::array<std::string_view, 6> computing = {"sort",        "sorted_copies", "keep_order",
                                                       "cell_factor", "grid_reuse",    "neighbours"};

const char* backend_text(BackendChoice choice) {
    switch (choice) {
        case BackendChoice::gpu:
            return "GPU";
        case BackendChoice::cpu:
            return "CPU mirror";
        case BackendChoice::threads:
            return "CPU threads";
        case BackendChoice::automatic:
            break;
    }
    return "auto";
}

std::string backend_preview(const State& state) {
    std::string shown = backend_text(state.backend);
    if (state.backend == BackendChoice::automatic) {
        shown += ": " + std::string(computer_text(state.backend_name));
    }
    return shown;
}

void backend_row(const State& state, Commands& commands) {
    const float button = ImGui::GetFrameHeight();
    row_label(
        "Backend",
        "What computes the balls: the GPU; the same stages one after the other on the CPU; or the same sums on all "
        "processors, sooner. Without a GPU, auto takes the last.",
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
        const bool slow_gpu = choice == BackendChoice::gpu && state.software;
        const char* const text = usable && slow_gpu ? "GPU (a CPU stands in: slower)" : backend_text(choice);
        if (ImGui::Selectable(usable ? text : "GPU (needs OpenGL 4.3)", choice == state.backend, flags)) {
            commands.push_back(ChooseBackend{choice});
        }
    }
    ImGui::EndCombo();
}

void setting_rows(const State& state, bool of_computing, Commands& commands) {
    Settings edited = state.settings;
    bool changed = false;
    for (const SettingInfo& info : setting_table()) {
        const bool computes = std::ranges::find(computing, info.key) != computing.end();
        if (computes == of_computing && has_row(info) && setting_applies(info, state.settings.laws)) {
            changed |= setting_row(info, state, edited);
        }
    }
    if (changed) {
        commands.push_back(ChangeSettings{edited});
    }
}

// Where several substeps use one grid: whether it is wide enough, and the cell factor that is.
void reuse_row(const State& state, Commands& commands) {
    if (state.settings.grid_reuse <= 1 || !state.has_grid || !state.settings.laws.diagnostics) {
        return;
    }
    const double way = drift(state.status);
    const double advised = cell_factor_for(way, state.largest_radius);
    wrapped_dim_text("Since the start balls went up to " + length_text(way) +
                     " while a grid was used; its cells allow " +
                     length_text(state.cell_width - 2.0 * state.largest_radius) + ".");
    if (way > 0.0 && advised != state.settings.cell_factor &&
        ImGui::Button(("Cell factor " + shortest_text(advised)).c_str())) {
        Settings edited = state.settings;
        edited.cell_factor = std::min(advised, find_setting("cell_factor")->maximum);
        commands.push_back(ChangeSettings{edited});
    }
}

}  // namespace

void settings_panel(const State& state, Commands& commands) {
    if (section("Settings", true)) {
        setting_rows(state, false, commands);
    }
    if (section("Computing", false)) {
        backend_row(state, commands);
        setting_rows(state, true, commands);
        reuse_row(state, commands);
    }
}

}  // namespace ballpit::ui
