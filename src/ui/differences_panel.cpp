// What a stage's check found: GPU | CPU | difference, one row an element.
#include <algorithm>
#include <cstring>
#include <string>

#include "measure/comparison.h"
#include "measure/slot_table.h"
#include "ui/stepping_panels.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

template <class T>
T word_at(std::span<const std::byte> bytes, std::size_t word) {
    T value{};
    if ((word + 1) * sizeof(T) <= bytes.size()) {
        std::memcpy(&value, bytes.data() + word * sizeof(T), sizeof(T));
    }
    return value;
}

std::string values(const SlotDifference& difference, std::span<const std::byte> bytes, std::size_t element) {
    std::string words;
    for (std::size_t column = 0; column < measure::slot_columns(difference.slot).size(); ++column) {
        words += (column == 0 ? "" : "  ") + measure::element_text(difference.slot, bytes, element, column);
    }
    return words;
}

// Of the first column that differs.
std::string distance(const SlotDifference& difference, std::size_t element) {
    const auto columns = measure::slot_columns(difference.slot);
    for (std::size_t column = 0; column < columns.size(); ++column) {
        const std::size_t word = element * columns.size() + column;
        const auto ours = word_at<std::uint32_t>(difference.gpu, word);
        const auto theirs = word_at<std::uint32_t>(difference.cpu, word);
        if (ours == theirs) {
            continue;
        }
        const std::string name(columns[column].name);
        if (!columns[column].is_float) {
            return name + format(" %+lld", static_cast<long long>(ours) - static_cast<long long>(theirs));
        }
        const auto a = word_at<float>(difference.gpu, word);
        const auto b = word_at<float>(difference.cpu, word);
        return name + format(" %+.3g, %s ULP", static_cast<double>(a) - static_cast<double>(b),
                             grouped(measure::ulp_distance(a, b)).c_str());
    }
    return "";
}

std::optional<std::uint32_t> ball_of(const SlotDifference& difference, std::uint32_t element) {
    if (difference.slot == Slot::cell_ranges || difference.slot == Slot::status) {
        return std::nullopt;
    }
    if (difference.slot != Slot::keys) {
        return element;
    }
    const auto ball = word_at<std::uint32_t>(difference.cpu, 2 * std::size_t{element} + 1);
    return ball == SENTINEL ? std::nullopt : std::optional(ball);
}

void difference_row(const SlotDifference& difference, std::uint32_t element, const State& state, Commands& commands) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const auto ball = ball_of(difference, element);
    const bool chosen = ball && state.inspection != nullptr && state.inspection->ball == ball;
    const std::string label = std::string(measure::slot_element(difference.slot)) + " " + grouped(element);
    if (ImGui::Selectable(label.c_str(), chosen, ImGuiSelectableFlags_SpanAllColumns) && ball) {
        commands.push_back(SelectBall{ball, true});
    }
    for (const auto& bytes : {difference.gpu, difference.cpu}) {
        ImGui::TableNextColumn();
        text(values(difference, bytes, element));
    }
    ImGui::TableNextColumn();
    text(distance(difference, element));
}

// Lines of text that a table takes.
float table_rows(const SlotDifference& difference) {
    return std::min(static_cast<float>(difference.differing.size()) + 1.6f, 8.6f);
}

void difference_table(const SlotDifference& difference, const State& state, Commands& commands) {
    const float rows = table_rows(difference);
    std::string names;
    for (const measure::SlotColumn& column : measure::slot_columns(difference.slot)) {
        names += (names.empty() ? "" : "  ") + std::string(column.name);
    }
    dim_text(std::string(slot_name(difference.slot)) + " (" + names + ") after " + std::string(difference.dispatch) +
             ": " + (difference.differing.size() < 1000 ? grouped(difference.differing.size()) : "the first thousand") +
             " of those that differ; click one to see its ball");
    constexpr auto flags = ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV | ImGuiTableFlags_ScrollY |
                           ImGuiTableFlags_SizingStretchProp;
    if (!ImGui::BeginTable(std::string(slot_name(difference.slot)).c_str(), 4, flags,
                           ImVec2(0.0f, rows * ImGui::GetTextLineHeightWithSpacing()))) {
        return;
    }
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn("where", 0, 1.0f);
    ImGui::TableSetupColumn("GPU", 0, 2.6f);
    ImGui::TableSetupColumn("CPU", 0, 2.6f);
    ImGui::TableSetupColumn("difference", 0, 1.7f);
    ImGui::TableHeadersRow();
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(difference.differing.size()));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            difference_row(difference, difference.differing[static_cast<std::size_t>(i)], state, commands);
        }
    }
    ImGui::EndTable();
}

}  // namespace

float differences_height(const State& state) {
    float lines = 4.5f;
    for (const SlotDifference& difference :
         state.stepping->check.stages[static_cast<std::size_t>(state.stepping->check.shown.value_or(Stage{}))]
             .differences) {
        lines += 1.0f + table_rows(difference);
    }
    return lines * ImGui::GetTextLineHeightWithSpacing() + 2.0f * em();
}

void differences_panel(const State& state, Commands& commands) {
    const LiveCheckState& check = state.stepping->check;
    if (!check.shown) {
        return;
    }
    const Stage stage = *check.shown;
    const Badge badge = stage_badge(check, stage);
    ImGui::PushStyleColor(ImGuiCol_Text, badge_colour(badge.kind));
    text(std::string(stage_name(stage)) + "  " + badge_text(badge));
    ImGui::PopStyleColor();
    if (!badge.detail.empty()) {
        wrapped_dim_text(badge.detail);
    }
    const StageCheck& found = check.stages[static_cast<std::size_t>(stage)];
    if (check.mode == LiveCheckMode::mirror && check.mirror_computes) {
        dim_text("The mirror is what computes: there is nothing to compare it with.");
    } else if (check.mode == LiveCheckMode::off) {
        dim_text("The check is off.");
    } else if (!found.ran) {
        dim_text("This stage has not run yet in this substep.");
    }
    for (const SlotDifference& difference : found.differences) {
        difference_table(difference, state, commands);
    }
    if (ImGui::Button("Close")) {
        commands.push_back(ShowDifferences{});
    }
}

}  // namespace ballpit::ui
