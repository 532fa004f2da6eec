// One ball: its way through the buffers in one line, and everyone it is tested against.
#include <algorithm>
#include <cmath>

#include "core/quarantine.h"
#include "ui/paging.h"
#include "ui/probe_panels.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

const ImVec4 touched_text{1.0f, 0.62f, 0.30f, 1.0f};  // as its ring in the picture, lighter
constexpr std::size_t most_runs = 9;                  // rows of cells that 27 cells make

std::string vector_text(const vec3& v) {
    return "(" + short_number(static_cast<double>(v.x)) + ", " + short_number(static_cast<double>(v.y)) + ", " +
           short_number(static_cast<double>(v.z)) + ")";
}

const CellRange* own_run(const measure::BallProbe& probe) {
    for (const CellRange& run : probe.runs) {
        if (*probe.slot >= run.first && *probe.slot < run.end) {
            return &run;
        }
    }
    return nullptr;
}

void trace_line(const State& state, Commands& commands) {
    bool first = true;
    for (const TraceLink& link : trace_links(*state.probe->follow, state.probe->within_substep)) {
        if (!first) {
            ImGui::SameLine(0.0f, 0.25f * em());
            dim_text("→");
            ImGui::SameLine(0.0f, 0.25f * em());
            if (ImGui::GetContentRegionAvail().x < ImGui::CalcTextSize(link.text.c_str()).x + em()) {
                ImGui::NewLine();  // large numbers, or a window pulled narrow
            }
        }
        ImGui::PushID(link.text.c_str());
        if (ImGui::SmallButton(link.text.c_str())) {
            commands.push_back(ShowElement{link.slot, link.element});
        }
        tooltip("In the buffer table: " + std::string(slot_name(link.slot)) + ", " + grouped(link.element));
        ImGui::PopID();
        first = false;
    }
}

void run_links(const measure::BallProbe& probe, Commands& commands) {
    for (std::size_t i = 0; i < std::min(probe.runs.size(), most_runs); ++i) {
        const CellRange& run = probe.runs[i];
        const std::string words = range_text(run.first, run.end);
        if (i > 0) {
            ImGui::SameLine();
            if (ImGui::GetContentRegionAvail().x < ImGui::CalcTextSize(words.c_str()).x + em()) {
                ImGui::NewLine();
            }
        }
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::SmallButton(words.c_str())) {
            commands.push_back(ShowElement{Slot::keys, run.first});
        }
        ImGui::PopID();
    }
}

void counts_line(const State& state, const measure::BallProbe& probe) {
    const ProbeState& view = *state.probe;
    if (!view.has_contacts) {
        wrapped_dim_text("This scene has no contacts: no ball asks for another.");
    } else if (!view.uses_grid) {
        text("Brute force tests " + grouped(probe.tested) + " balls, " + grouped(probe.touched) + " touch.");
    } else if (probe.cells.empty()) {
        wrapped_dim_text(probe.slot ? "Its cell has no range of slots yet in this substep: build_grid comes later."
                                    : "It has no key yet in this substep: assign_cells comes first.");
    } else {
        text(format("%zu cells hold ", probe.cells.size()) + grouped(probe.tested) + " other balls: tested. " +
             grouped(probe.touched) + (probe.touched == 1 ? " touches." : " touch."));
        dim_text("Slots:");
        tooltip("The runs of slots that its cells take up; cells that follow each other in x share one.");
        ImGui::SameLine();
    }
}

void neighbour_line(const measure::NeighbourRow& row, Commands& commands) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushID(static_cast<int>(row.ball));
    if (ImGui::Selectable(grouped(row.ball).c_str(), false, ImGuiSelectableFlags_SpanAllColumns)) {
        commands.push_back(SelectBall{row.ball, false});
    }
    ImGui::PopID();
    ImGui::TableNextColumn();
    if (row.cell_id) {
        text(grouped(*row.cell_id));
    }
    ImGui::TableNextColumn();
    if (row.slot) {
        text(grouped(*row.slot));
    }
    ImGui::TableNextColumn();
    text(short_number(static_cast<double>(row.distance)));
    ImGui::TableNextColumn();
    if (row.touches) {
        ImGui::PushStyleColor(ImGuiCol_Text, touched_text);
        text("● " + short_number(static_cast<double>(row.overlap)));
        ImGui::PopStyleColor();
    } else {
        dim_text("apart " + short_number(-static_cast<double>(row.overlap)));
    }
}

void neighbour_table(const measure::BallProbe& probe, Commands& commands) {
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit;
    const float room = std::max(ImGui::GetContentRegionAvail().y, 5.0f * em());
    if (!ImGui::BeginTable("neighbours", 5, flags, ImVec2(0.0f, room))) {
        return;
    }
    ImGui::TableSetupScrollFreeze(0, 1);
    for (const char* heading : {"ball", "cell", "slot", "distance (m)", "overlap (m)"}) {
        ImGui::TableSetupColumn(heading, ImGuiTableColumnFlags_WidthStretch);
    }
    ImGui::TableHeadersRow();
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(probe.rows.size()));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            neighbour_line(probe.rows[static_cast<std::size_t>(i)], commands);
        }
    }
    ImGui::EndTable();
}

void quarantine_line(const measure::BallProbe& probe, Commands& commands) {
    if (in_quarantine(probe.position)) {
        text("In quarantine: held where it was last, at rest. It touches nobody.");
    }
    if (probe.next_quarantined && probe.next_quarantined != probe.ball) {
        if (ImGui::SmallButton(("Next in quarantine: " + grouped(*probe.next_quarantined)).c_str())) {
            commands.push_back(SelectBall{*probe.next_quarantined, true});
        }
    }
}

void search_line(const ProbeState& view, Commands& commands) {
    if (const auto wanted = number_field("Ball", "Type a number and press Enter.", view.ball)) {
        commands.push_back(SelectBall{*wanted, false});
    }
    if (!view.ball) {
        return;
    }
    ImGui::SameLine();
    if (ImGui::Button("Fly there")) {
        commands.push_back(SelectBall{view.ball, true});
    }
    ImGui::SameLine();
    if (key_button("Clear", key_hint(Action::clear_selection), 7.0f * em())) {
        commands.push_back(Action::clear_selection);
    }
}

}  // namespace

std::vector<TraceLink> trace_links(const measure::BallProbe& probe, bool within_substep) {
    std::vector<TraceLink> links;
    const Slot positions = within_substep ? Slot::positions : Slot::next_positions;
    links.push_back({"ball " + grouped(probe.ball), positions, probe.ball});
    if (probe.cell_id) {
        links.push_back({"cell " + grouped(*probe.cell_id), Slot::cell_ranges, *probe.cell_id});
    }
    if (probe.slot) {
        links.push_back({"slot " + grouped(*probe.slot), Slot::keys, *probe.slot});
        if (const CellRange* run = own_run(probe)) {
            std::string words = "neighbours " + range_text(run->first, run->end);
            if (probe.runs.size() > 1) {
                words += format(" +%zu runs", probe.runs.size() - 1);
            }
            links.push_back({words, Slot::keys, run->first});
        }
    }
    if (probe.velocity_change) {
        const Slot after = within_substep ? Slot::next_velocities : Slot::velocities;
        links.push_back({"Δv " + vector_text(*probe.velocity_change) + " m/s", after, probe.ball});
    }
    return links;
}

void follow_panel(const State& state, Commands& commands) {
    const ProbeState& view = *state.probe;
    search_line(view, commands);
    if (!view.ball) {
        wrapped_dim_text("Click a ball, or type its number and press Enter.");
        return;
    }
    if (view.follow == nullptr) {
        dim_text(*view.ball >= view.ball_count ? "There is no such ball now." : "Waiting for the buffers …");
        return;
    }
    const measure::BallProbe& probe = *view.follow;
    trace_line(state, commands);
    dim_text("at " + vector_text(vec3(probe.position)) + " m   v " + vector_text(vec3(probe.velocity)) +
             " m/s   radius " + short_number(std::abs(static_cast<double>(probe.position.w))) + " m   mass " +
             short_number(static_cast<double>(probe.velocity.w)) + " kg");
    quarantine_line(probe, commands);
    counts_line(state, probe);
    run_links(probe, commands);
    if (!probe.rows.empty()) {
        neighbour_table(probe, commands);
    }
}

}  // namespace ballpit::ui
