// The table of cells: sorted, searched, clicked; and the slice through the grid.
#include <algorithm>
#include <array>

#include "measure/neighbours.h"
#include "ui/paging.h"
#include "ui/probe_panels.h"
#include "ui/style.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

constexpr std::array<const char*, 7> headings = {"cell", "x", "y", "z", "first", "end", "balls"};
constexpr std::size_t most_listed = 100;

// Balls and cells of the copies that are shown; a cell without a range holds none.
std::uint32_t balls_in(const CellRange& range) { return range.end - range.first; }

void search_line(const ProbeState& view, ProbeOptions& options, bool& changed, Commands& commands) {
    if (const auto cell =
            number_field("Cell", "Type a cell id and press Enter: its row, and the cell in the picture.", view.cell)) {
        commands.push_back(SelectCell{*cell});
    }
    ImGui::SameLine();
    if (const auto ball = number_field("of ball", "Type a ball's number and press Enter: the cell that it is in.")) {
        commands.push_back(SelectCellOfBall{*ball});
    }
    ImGui::SameLine();
    changed |= ImGui::Checkbox("only occupied", &options.cell_order.only_occupied);
    changed |= ImGui::Checkbox("a click picks a cell", &options.click_picks_cell);
    tooltip("Otherwise it picks a ball. With Ctrl held it picks the other.");
    if (view.cell) {
        ImGui::SameLine();
        if (key_button("Clear", key_hint(Action::clear_selection), 6.5f * em())) {
            commands.push_back(Action::clear_selection);
        }
    }
}

void slice_line(const ProbeState& view, ProbeOptions& options, bool& changed) {
    changed |= key_checkbox("Slice", options.slice, key_hint(Action::toggle_slice));
    if (!options.slice) {
        return;
    }
    for (const int axis : {0, 1, 2}) {
        ImGui::SameLine();
        changed |=
            ImGui::RadioButton(std::array{"x", "y", "z"}[static_cast<std::size_t>(axis)], &options.slice_axis, axis);
    }
    ImGui::SameLine();
    changed |= ImGui::Checkbox("cut away", &options.slice_cut);
    tooltip("Leaves out the balls between the layer and the eye.");
    const std::uint32_t most = std::max(view.grid_cells[options.slice_axis], 1u) - 1;
    const std::uint32_t least = 0;
    std::uint32_t layer = std::min(options.slice_layer, most);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    if (ImGui::SliderScalar("##layer", ImGuiDataType_U32, &layer, &least, &most, "layer %u")) {
        options.slice_layer = layer;
        changed = true;
    }
}

// The headings' arrows are ImGui's; a click on one is a command as any other.
void take_sorting(ProbeOptions& options, bool& changed) {
    ImGuiTableSortSpecs* specs = ImGui::TableGetSortSpecs();
    if (specs == nullptr || !specs->SpecsDirty || specs->SpecsCount == 0) {
        return;
    }
    specs->SpecsDirty = false;
    measure::CellOrder wanted = options.cell_order;
    wanted.column = static_cast<measure::CellColumn>(specs->Specs[0].ColumnIndex);
    wanted.descending = specs->Specs[0].SortDirection == ImGuiSortDirection_Descending;
    changed |= !(wanted == options.cell_order);
    options.cell_order = wanted;
}

void cell_row(const ProbeState& view, std::uint32_t cell, Commands& commands) {
    const measure::BufferSample& sample = *view.sample;
    const uvec3 place = measure::cell_of_id(sample.grid, cell);
    const CellRange& range = sample.cell_ranges[cell];
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushID(static_cast<int>(cell));
    if (ImGui::Selectable(grouped(cell).c_str(), view.cell == cell, ImGuiSelectableFlags_SpanAllColumns)) {
        commands.push_back(SelectCell{cell});
    }
    ImGui::PopID();
    for (const std::uint32_t number : {place.x, place.y, place.z, range.first, range.end, balls_in(range)}) {
        ImGui::TableNextColumn();
        if (range.first == range.end) {
            dim_text(grouped(number));
        } else {
            text(grouped(number));
        }
    }
}

void cell_table(const ProbeState& view, ProbeOptions& options, bool& changed, Commands& commands, float height) {
    Pager pager("cells", view.cells.size());
    const auto row = measure::row_of_cell(view.cells, static_cast<std::uint32_t>(view.cell_jump.element));
    pager.follow(view.cell_jump, row);
    pager.draw();
    constexpr ImGuiTableFlags flags =
        ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_Sortable | ImGuiTableFlags_BordersInnerV;
    if (!ImGui::BeginTable("cells", static_cast<int>(headings.size()), flags, ImVec2(0.0f, height))) {
        return;
    }
    ImGui::TableSetupScrollFreeze(0, 1);
    for (std::size_t i = 0; i < headings.size(); ++i) {
        const bool chosen = i == static_cast<std::size_t>(options.cell_order.column);
        ImGui::TableSetupColumn(headings[i],
                                ImGuiTableColumnFlags_WidthStretch | (chosen ? ImGuiTableColumnFlags_DefaultSort : 0),
                                i == 0 || i >= 4 ? 1.5f : 1.0f);
    }
    ImGui::TableHeadersRow();
    take_sorting(options, changed);
    const float line = ImGui::GetTextLineHeight() + 2.0f * ImGui::GetStyle().CellPadding.y;
    pager.scroll(line);
    ImGuiListClipper clipper;
    clipper.Begin(pager.rows_here(), line);
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            cell_row(view, view.cells[pager.first_row() + static_cast<std::uint64_t>(i)], commands);
        }
    }
    ImGui::EndTable();
}

void balls_of_selected(const ProbeState& view, Commands& commands) {
    if (!view.cell || *view.cell >= view.sample->cell_ranges.size()) {
        dim_text("Click a row, or a cell in the picture.");
        return;
    }
    const std::vector<std::uint32_t> balls = measure::balls_of_cell(*view.sample, *view.cell);
    const uvec3 place = measure::cell_of_id(view.sample->grid, *view.cell);
    text("Cell " + grouped(*view.cell) + format(" (%u, %u, %u) holds ", place.x, place.y, place.z) +
         (balls.empty() ? "no balls" : grouped(balls.size()) + (balls.size() == 1 ? " ball:" : " balls:")));
    const std::size_t listed = std::min(balls.size(), most_listed);
    for (std::size_t i = 0; i < listed; ++i) {
        const std::string words = grouped(balls[i]);
        ImGui::SameLine();
        if (ImGui::GetContentRegionAvail().x < ImGui::CalcTextSize(words.c_str()).x + em()) {
            ImGui::NewLine();
        }
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::SmallButton(words.c_str())) {
            commands.push_back(SelectBall{balls[i], false});
        }
        ImGui::PopID();
    }
    if (listed < balls.size()) {
        dim_text("and " + grouped(balls.size() - listed) + " more: slots " +
                 range_text(view.sample->cell_ranges[*view.cell].first, view.sample->cell_ranges[*view.cell].end));
    }
}

}  // namespace

void cells_panel(const State& state, Commands& commands) {
    const ProbeState& view = *state.probe;
    if (!view.has_contacts || !view.uses_grid) {
        wrapped_dim_text(view.has_contacts ? "Brute force needs no grid. Set Neighbours to grid to have one."
                                           : "This scene has no contacts, so it needs no cells.");
        return;
    }
    ProbeOptions options = view.options;
    bool changed = false;
    search_line(view, options, changed, commands);
    slice_line(view, options, changed);
    if (view.sample == nullptr || view.sample->cell_ranges.empty()) {
        wrapped_dim_text(view.sample == nullptr ? "Waiting for the buffers …"
                                                : "build_grid has not run yet in this substep.");
    } else {
        const float below = 3.0f * ImGui::GetFrameHeightWithSpacing();
        cell_table(view, options, changed, commands,
                   std::max(ImGui::GetContentRegionAvail().y - below, 6.0f * ImGui::GetFrameHeight()));
        balls_of_selected(view, commands);
    }
    if (changed) {
        commands.push_back(ChangeProbe{options});
    }
}

}  // namespace ballpit::ui
