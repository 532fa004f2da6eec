// Every slot of the layout as a table with typed columns: paged, searched, exported.
#include <algorithm>

#include "measure/slot_table.h"
#include "ui/paging.h"
#include "ui/probe_panels.h"
#include "ui/setting_row.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

void right_aligned(const std::string& words, bool dim) {
    const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(words.c_str()).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, room));
    if (dim) {
        dim_text(words);
    } else {
        text(words);
    }
}

void slot_choice(const State& state, ProbeOptions& options, bool& changed) {
    ImGui::SetNextItemWidth(9.5f * em());
    if (!ImGui::BeginCombo("##slot", slot_name(options.slot).data(), ImGuiComboFlags_HeightLarge)) {
        return;
    }
    if (state.close_popups) {
        ImGui::CloseCurrentPopup();
    }
    for (std::size_t i = 0; i < slot_count; ++i) {
        const auto slot = static_cast<Slot>(i);
        if (ImGui::Selectable(slot_name(slot).data(), slot == options.slot)) {
            changed |= slot != options.slot;
            options.slot = slot;
        }
    }
    ImGui::EndCombo();
}

void search_line(const ProbeState& view, Commands& commands) {
    const Slot slot = view.options.slot;
    const std::string name(measure::slot_element(slot));
    if (const auto element = number_field(name.c_str(), "Type a number and press Enter: the table goes there.")) {
        commands.push_back(ShowElement{slot, *element});
    }
    if (slot == Slot::keys) {
        ImGui::SameLine();
        if (const auto ball = number_field("of ball", "Type a ball's number and press Enter: the slot of its key.")) {
            if (const auto element = measure::element_of_ball(slot, view.buffer, *ball)) {
                commands.push_back(ShowElement{slot, *element});
            }
        }
    }
    ImGui::SameLine();
    ImGui::BeginDisabled(view.buffer.empty());
    if (ImGui::Button("Export CSV")) {
        commands.push_back(ExportSlot{slot});
    }
    ImGui::EndDisabled();
    tooltip("Writes the whole slot, as it was copied, into a file in the folder that the program was started in.");
}

std::optional<std::uint32_t> ball_of(Slot slot, std::span<const std::byte> bytes, std::uint64_t element) {
    if (measure::slot_element(slot) == "ball") {
        return static_cast<std::uint32_t>(element);
    }
    if (slot == Slot::keys) {
        const std::uint32_t ball = typed<Key>(bytes.subspan(element * sizeof(Key), sizeof(Key))).front().ball_id;
        return ball == SENTINEL ? std::nullopt : std::optional(ball);
    }
    return std::nullopt;
}

void element_row(const ProbeState& view, std::uint64_t element, Commands& commands) {
    const Slot slot = view.options.slot;
    const auto ball = ball_of(slot, view.buffer, element);
    const bool padding = slot == Slot::keys && !ball;
    const bool cells = slot == Slot::cell_ranges;
    const bool chosen = (ball && ball == view.ball) || (cells && view.cell == element) ||
                        (view.buffer_jump.serial != 0 && view.buffer_jump.element == element && !view.ball);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushID(static_cast<int>(element));
    if (ImGui::Selectable(grouped(element).c_str(), chosen, ImGuiSelectableFlags_SpanAllColumns)) {
        if (ball) {
            commands.push_back(SelectBall{*ball, false});
        } else if (cells) {
            commands.push_back(SelectCell{static_cast<std::uint32_t>(element)});
        }
    }
    ImGui::PopID();
    for (std::size_t column = 0; column < measure::slot_columns(slot).size(); ++column) {
        ImGui::TableNextColumn();
        right_aligned(padding ? "padding" : measure::element_text(slot, view.buffer, element, column), padding);
    }
}

void header_row(Slot slot) {
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn(measure::slot_element(slot).data(), ImGuiTableColumnFlags_WidthStretch, 0.7f);
    for (const measure::SlotColumn& column : measure::slot_columns(slot)) {
        std::string heading(column.name);
        if (!column.unit.empty()) {
            heading += " (" + shown_unit(column.unit) + ")";
        }
        ImGui::TableSetupColumn(heading.c_str());
    }
    ImGui::TableHeadersRow();
}

void element_table(const ProbeState& view, Commands& commands) {
    const Slot slot = view.options.slot;
    const std::uint64_t rows = measure::element_count(slot, view.buffer);
    Pager pager(slot_name(slot).data(), rows);
    pager.follow(view.buffer_jump, view.buffer_jump.element);
    pager.draw();
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV;
    const int columns = static_cast<int>(measure::slot_columns(slot).size()) + 1;
    if (!ImGui::BeginTable(slot_name(slot).data(), columns, flags, ImVec2(0.0f, ImGui::GetContentRegionAvail().y))) {
        return;
    }
    header_row(slot);
    const float line = ImGui::GetTextLineHeight() + 2.0f * ImGui::GetStyle().CellPadding.y;
    pager.scroll(line);
    ImGuiListClipper clipper;
    clipper.Begin(pager.rows_here(), line);
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            element_row(view, pager.first_row() + static_cast<std::uint64_t>(i), commands);
        }
    }
    ImGui::EndTable();
}

void moment_line(const State& state) {
    const ProbeState& view = *state.probe;
    std::string words = grouped(measure::element_count(view.options.slot, view.buffer)) + " × " +
                        format("%zu", measure::slot_columns(view.options.slot).size()) + " words";
    if (state.running) {
        words += format(", copied %.3g times a second, %.2f s ago", view.options.copies_a_second, view.age_s);
    } else {
        words += ", as it is now";
    }
    dim_text(words);
}

}  // namespace

void buffers_panel(const State& state, Commands& commands) {
    const ProbeState& view = *state.probe;
    ProbeOptions options = view.options;
    bool changed = false;
    slot_choice(state, options, changed);
    ImGui::SameLine();
    search_line(view, commands);
    if (changed) {
        commands.push_back(ChangeProbe{options});
    }
    if (view.buffer.empty()) {
        wrapped_dim_text(view.buffer_waiting ? "Waiting for the first copy …"
                                             : "Empty: this scene, with these settings, does not use it.");
        return;
    }
    moment_line(state);
    element_table(view, commands);
}

}  // namespace ballpit::ui
