#include "ui/budget_panel.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string>

#include "ui/tool_window.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

constexpr int columns = 6;

std::string capital(std::string_view name) {
    std::string words(name);
    words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
    return words;
}

void preset_buttons(const BudgetState& budget, Commands& commands) {
    const auto& names = measure::budget_preset_names;
    const float width = column_width(static_cast<int>(names.size()));
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto preset = static_cast<measure::BudgetPreset>(i);
        const BudgetOptions options{budget_of(preset), preset == measure::BudgetPreset::historical};
        if (i > 0) {
            ImGui::SameLine();
        }
        const bool on = options == budget.options;
        if (key_button(capital(names[i]).c_str(), "", width, on)) {
            commands.push_back(ChangeBudget{options});
        }
        tooltip(capital(measure::budget_preset_meaning(preset)) + ".");
    }
}

// Per cent of `value`.
bool allowed_row(const char* label, const char* about, const char* pattern, double& value) {
    constexpr double low = 100.0 * least_allowed;
    constexpr double high = 100.0 * most_allowed;
    double percent = 100.0 * value;
    row_label(label, about);
    ImGui::PushID(label);
    const bool changed = ImGui::SliderScalar("##allowed", ImGuiDataType_Double, &percent, &low, &high, pattern,
                                             ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
    ImGui::PopID();
    if (changed && std::isfinite(percent)) {
        value = std::clamp(percent, low, high) / 100.0;
    }
    return changed;
}

void allowed_rows(const BudgetState& budget, Commands& commands) {
    BudgetOptions options = budget.options;
    measure::ErrorBudget& allowed = options.budget;
    bool changed =
        allowed_row("Restitution", "By how much of the approach speed the speed after a collision may be off.",
                    "%.3g %%", allowed.restitution);
    changed |= allowed_row("Overlap", "By how much of a diameter the largest overlap of a collision may be off.",
                           "%.3g %%", allowed.overlap);
    changed |= allowed_row("Energy", "What time steps may make or eat of the kinetic energy in a second.", "%.3g %%/s",
                           allowed.energy);
    if (changed) {
        options.historical = false;
        commands.push_back(ChangeBudget{options});
    }
}

void choice_rows(const State& state, Commands& commands) {
    const BudgetState& budget = *state.budget;
    if (!budget.choice) {
        wrapped_dim_text(budget.measuring ? "measuring …" : "–");
        return;
    }
    const measure::BudgetChoice& choice = *budget.choice;
    wrapped_text(budget.sentence + ".");
    if (choice.nothing) {
        return;
    }
    ImGui::BeginDisabled(budget.applied);
    const std::string label = format("Apply %u %s", choice.substeps, choice.substeps == 1 ? "substep" : "substeps");
    if (key_button((label + "###apply").c_str(), "", column_width(2), !budget.applied)) {
        Settings settings = state.settings;
        settings.substeps = choice.substeps;
        settings.integrator = choice.integrator;
        commands.push_back(ChangeSettings{settings});
    }
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (budget.substep_ms) {
        wrapped_dim_text(format("%.3g ms a substep: %.3g ms for %u, %.3g ms for the %u of now", *budget.substep_ms,
                                *budget.substep_ms * choice.substeps, choice.substeps,
                                *budget.substep_ms * state.settings.substeps, state.settings.substeps));
    } else {
        wrapped_dim_text("A substep's price is known once the scene has run.");
    }
}

// One quantity of one kind of collision. `scale` and `pattern`: as it is shown; `allowed`: of the error, 0: nothing.
struct Quantity {
    const char* name;
    const measure::Spread* spread;
    double scale;
    const char* pattern;
    double allowed;
};

void cell(const Quantity& quantity, double value, bool alarm = false) {
    ImGui::TableNextColumn();
    if (alarm) {
        ImGui::TableSetBgColor(ImGuiTableBgTarget_CellBg, packed(alarm_colour));
    }
    std::array<char, 48> words{};
    std::snprintf(words.data(), words.size(), quantity.pattern, quantity.scale * value);
    text(words.data());
}

void quantity_row(const Quantity& quantity) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    text(quantity.name);
    cell(quantity, quantity.spread->exact);
    cell(quantity, quantity.spread->mean);
    cell(quantity, quantity.spread->deviation);
    cell(quantity, quantity.spread->worst);
    cell(quantity, quantity.spread->error, quantity.allowed > 0.0 && quantity.spread->error > quantity.allowed);
}

void group_rows(const measure::ProbeGroup& group, const measure::ErrorBudget& allowed) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    dim_text(format("%s, %.3g m/s", group.wall ? "Ball and wall" : "Two balls", group.speed));
    if (group.passes_through()) {
        ImGui::TableNextColumn();
        dim_text("pass through");
    } else if (group.unending > 0) {
        ImGui::TableNextColumn();
        dim_text(format("%u never end", group.unending));
    }
    const double bound = group.passes_through() ? 0.0 : 1.0;
    quantity_row({"restitution", &group.restitution, 1.0, "%.5f", bound * allowed.restitution});
    quantity_row({"overlap, diameters", &group.overlap, 1.0, "%.5f", bound * allowed.overlap});
    quantity_row({"duration, ms", &group.duration, 1000.0, "%.4g", 0.0});
    quantity_row({"energy gain, %", &group.gain, 100.0, "%.3g", 0.0});
}

void probe_table(const BudgetState& budget) {
    constexpr auto flags = ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV | ImGuiTableFlags_ScrollY;
    if (!ImGui::BeginTable("probe", columns, flags)) {
        return;
    }
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn("256 collisions", ImGuiTableColumnFlags_WidthStretch, 1.7f);
    for (const char* name : {"exact", "mean", "spread", "worst", "error 95 %"}) {
        ImGui::TableSetupColumn(name, ImGuiTableColumnFlags_WidthStretch, 1.0f);
    }
    ImGui::TableHeadersRow();
    for (const measure::ProbeGroup& group : budget.probe->groups) {
        group_rows(group, budget.options.budget);
    }
    ImGui::EndTable();
}

void probe_rows(const State& state) {
    const BudgetState& budget = *state.budget;
    if (!budget.probe) {
        return;
    }
    if (!budget.probe->nothing.empty()) {
        wrapped_dim_text(budget.probe->nothing + ".");
        return;
    }
    wrapped_text(format("Now: %u substeps, %.3g of them a contact; energy drifts by %.3g %% a second.",
                        state.settings.substeps, budget.probe->substeps_a_contact, 100.0 * budget.drift));
    std::string about = format("Measured with this scene's programs, %.0f substeps of 256 single collisions in %.3g ms",
                               static_cast<double>(budget.probe_substeps), budget.probe_ms);
    about += budget.speed_is_assumed ? "; nothing moves or falls here, so the speed is assumed."
                                     : format("; balls have or can fall to %.3g m/s, typically %.3g m/s.",
                                              budget.largest_speed, budget.typical_speed);
    wrapped_dim_text(about);
    if (budget.probe->softness() > 0.05) {
        wrapped_dim_text(format("The fastest overlap by %.3g diameters; a stiffness of %.3g N/m would make it 0.05.",
                                budget.probe->softness(), budget.firm_stiffness));
    }
    probe_table(budget);
}

}  // namespace

void budget_section(const State& state, Commands& commands) {
    if (!section("Accuracy", false)) {
        return;
    }
    wrapped_dim_text("How much may be wrong, how many substeps that takes, and what each choice costs.");
    if (key_button("Error budget", key_hint(Action::toggle_budget), column_width(1), state.view.budget)) {
        commands.push_back(Action::toggle_budget);
    }
    if (key_button("Speed and accuracy", key_hint(Action::toggle_explorer), column_width(1), state.view.explorer)) {
        commands.push_back(Action::toggle_explorer);
    }
    if (key_button("Cost and number of balls", key_hint(Action::toggle_costs), column_width(1), state.view.costs)) {
        commands.push_back(Action::toggle_costs);
    }
}

void budget_panel(const State& state, Commands& commands) {
    preset_buttons(*state.budget, commands);
    allowed_rows(*state.budget, commands);
    ImGui::Separator();
    choice_rows(state, commands);
    ImGui::Separator();
    probe_rows(state);
}

void draw_budget_window(const State& state, Commands& commands) {
    if (state.budget == nullptr) {
        return;
    }
    const ImVec2 room = free_room(state);
    const float below_rate = 6.0f * em();
    const ImVec2 size(std::min(46.0f * em(), room.x), room.y - below_rate);
    if (!tool_window(state, "Error budget", ImVec2(window_margin(), below_rate), size,
                     [&] { budget_panel(state, commands); })) {
        commands.push_back(Action::toggle_budget);
    }
}

}  // namespace ballpit::ui
