#include "ui/laws_panel.h"

#include <algorithm>
#include <string>

#include "ui/tool_window.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

constexpr float name_width = 10.6f;  // em
constexpr float cost_width = 9.5f;
constexpr float side_by_side = 34.0f;  // em: narrower windows have one column

void tick_box(const LawInfo& law, const LawStanding& standing, const State& state, Commands& commands) {
    bool holds = standing.holds;
    ImGui::BeginDisabled(standing.locked);
    if (ImGui::Checkbox(law.label.data(), &holds)) {
        Settings settings = state.settings;
        settings.laws.*law.member = holds;
        commands.push_back(ChangeSettings{settings});
    }
    ImGui::EndDisabled();
}

void about(const LawInfo& law, const LawStanding& standing) {
    wrapped_text(law.about);
    wrapped_dim_text("Asks for: " + std::string(law.price));
    if (!standing.why.empty()) {
        wrapped_dim_text(standing.why);
    }
}

void cost(std::size_t law, const LawStanding& standing, const LawsState& laws) {
    if (standing.locked) {
        wrapped_dim_text("–");
    } else if (const auto& known = laws.costs[law]) {
        const std::string words = cost_text(*known, standing.holds, laws.substep_ms.value_or(0.0));
        standing.holds && !known->same_programs ? wrapped_text(words) : wrapped_dim_text(words);
    } else {
        wrapped_dim_text(laws.measuring ? "– (being measured)" : "–");
    }
}

void law_row(std::size_t i, const State& state, Commands& commands) {
    const LawInfo& law = law_table()[i];
    const LawStanding standing =
        standing_of(law, state.settings.laws, state.defaults.laws, state.variety, state.own_restitutions);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    tick_box(law, standing, state, commands);
    if (ImGui::TableGetColumnCount() == 1) {
        about(law, standing);
        cost(i, standing, *state.laws);
        return;
    }
    ImGui::TableNextColumn();
    about(law, standing);
    ImGui::TableNextColumn();
    cost(i, standing, *state.laws);
}

void totals(const LawsState& laws) {
    std::string words = format("%.4g B a ball  ·  %zu %s a substep", laws.bytes_a_ball, laws.dispatches,
                               laws.dispatches == 1 ? "dispatch" : "dispatches");
    if (laws.substep_ms) {
        words += "  ·  " + short_number(*laws.substep_ms) + " ms";
    }
    wrapped_text(words);
    std::string programs;
    for (const std::string& program : laws.programs) {
        programs += (programs.empty() ? "" : "  ·  ") + program;
    }
    wrapped_dim_text(programs.empty() ? "No balls: nothing runs." : programs);
    for (const std::string& sentence : laws.on_demand) {
        wrapped_dim_text(sentence);
    }
}

void measure_row(const LawsState& laws, Commands& commands) {
    ImGui::BeginDisabled(laws.measuring || laws.ball_count == 0);
    if (ImGui::Button("Measure again")) {
        commands.push_back(MeasureLaws{});
    }
    ImGui::EndDisabled();
    tooltip(
        "Substeps of a copy of the present state run in turn with a law and without it. A cost is the median of nine "
        "differences; the ± around it holds the true one in 96 % of all cases.");
    ImGui::SameLine();
    wrapped_dim_text(laws.measuring ? "measuring …" : "costs are a substep's, of the state when they were measured");
}

}  // namespace

void laws_section(const State& state, Commands& commands) {
    if (!section("Laws", false)) {
        return;
    }
    std::string names;
    for (const LawInfo& law : law_table()) {
        if (standing_of(law, state.settings.laws, state.defaults.laws, state.variety, state.own_restitutions).holds) {
            names += (names.empty() ? "" : ", ") + std::string(law.label);
        }
    }
    wrapped_dim_text(names.empty() ? "None: balls move on as they are." : names);
    if (key_button("Laws of this scene", key_hint(Action::toggle_laws), column_width(1))) {
        commands.push_back(Action::toggle_laws);
    }
}

void laws_panel(const State& state, Commands& commands) {
    totals(*state.laws);
    measure_row(*state.laws, commands);
    ImGui::Separator();
    const bool wide = ImGui::GetContentRegionAvail().x > side_by_side * em();
    constexpr auto flags = ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_ScrollY;
    if (!ImGui::BeginTable(wide ? "laws" : "laws, narrow", wide ? 3 : 1, flags)) {
        return;
    }
    if (wide) {
        ImGui::TableSetupColumn("law", ImGuiTableColumnFlags_WidthFixed, name_width * em());
        ImGui::TableSetupColumn("about", ImGuiTableColumnFlags_WidthStretch);
        ImGui::TableSetupColumn("cost", ImGuiTableColumnFlags_WidthFixed, cost_width * em());
    }
    for (std::size_t i = 0; i < law_count; ++i) {
        law_row(i, state, commands);
    }
    ImGui::EndTable();
}

void draw_laws_window(const State& state, Commands& commands) {
    if (state.laws == nullptr) {
        return;
    }
    const ImVec2 room = free_room(state);
    const float below_rate = 6.0f * em();
    const ImVec2 size(std::min(52.0f * em(), room.x), room.y - below_rate);
    if (!tool_window(state, "Laws of this scene", ImVec2(window_margin(), below_rate), size,
                     [&] { laws_panel(state, commands); })) {
        commands.push_back(Action::toggle_laws);
    }
}

}  // namespace ballpit::ui
