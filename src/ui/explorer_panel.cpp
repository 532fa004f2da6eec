#include "ui/explorer_panel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "measure/pareto.h"
#include "ui/explorer.h"
#include "ui/log_plot.h"
#include "ui/tool_window.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

using measure::SweepMetric;
using measure::SweepRow;

const ImU32 front_colour = packed(vec3(0.96f, 0.97f, 0.98f));
const ImU32 budget_colour = packed(vec3(0.90f, 0.62f, 0.00f));
const ImU32 floor_colour = packed(vec3(0.66f, 0.71f, 0.77f));
const ImU32 here_colour = packed(vec3(1.0f, 1.0f, 1.0f));
const ImU32 unknowable = packed(vec3(0.5f, 0.5f, 0.5f), 0.25f);

constexpr double smallest_shown = 1e-12;  // an error of 0 has no logarithm

std::optional<double> shown_error(const SweepRow& row, SweepMetric metric) {
    const auto value = measure::metric_of(row, metric);
    return value && std::isfinite(*value) ? std::optional(std::max(*value, smallest_shown)) : std::nullopt;
}

// What the sweep that ended has left.
std::string outcome(const ExplorerState& explorer) {
    if (explorer.stale) {
        return "The scene is another one now than when this was measured.";
    }
    if (explorer.rows.empty()) {
        return "Ended before the first choice was whole: the exact run that positions are compared with comes first.";
    }
    const std::string of_all =
        explorer.rows.size() < explorer.wanted ? format(" of %zu, then it was ended", explorer.wanted) : "";
    return format("%zu choices%s, each %.3g s of the scene from its start", explorer.rows.size(), of_all.c_str(),
                  explorer.seconds);
}

void controls(const ExplorerState& explorer, Commands& commands) {
    if (explorer.running) {
        if (ImGui::Button("Stop")) {
            commands.push_back(StopSweep{});
        }
        tooltip("What was measured so far stays.");
        ImGui::SameLine();
        const std::string words =
            format("%zu of %zu", explorer.rows.size(), explorer.wanted) +
            (explorer.seconds_left ? format("  ·  %.0f s left", std::ceil(*explorer.seconds_left)) : std::string());
        ImGui::ProgressBar(static_cast<float>(explorer.progress), ImVec2(-1.0f, 0.0f), words.c_str());
    } else {
        if (ImGui::Button(explorer.wanted == 0 ? "Measure this scene" : "Measure again")) {
            commands.push_back(StartSweep{});
        }
        ImGui::SameLine();
        wrapped_dim_text(explorer.wanted == 0
                             ? "Runs copies of the scene from its start with other substeps and integrators, with "
                               "compensated sums, and with one grid for several substeps."
                             : outcome(explorer));
    }
}

void metric_choice(const ExplorerState& explorer, Commands& commands) {
    constexpr std::array names = {"Position", "Energy", "Overlap", "Restitution"};
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) {
            ImGui::SameLine();
        }
        const auto metric = static_cast<SweepMetric>(i);
        if (ImGui::RadioButton(names[i], explorer.metric == metric)) {
            commands.push_back(ChooseMetric{metric});
        }
    }
}

// The symbols in words: shape and filling, not colour alone.
void key_to_symbols(const ExplorerState& explorer) {
    const auto entry = [](const measure::SweepPoint& point, const std::string& words) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        draw_symbol(ImGui::GetWindowDrawList(), ImVec2(at.x + 0.5f * em(), at.y + 0.55f * em()), 0.32f * em(), point);
        ImGui::Dummy(ImVec2(em(), em()));
        ImGui::SameLine();
        dim_text(words);
    };
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    bool first = true;
    const auto next_to = [&](float width) {
        if (!first && ImGui::GetItemRectMax().x + width < right) {
            ImGui::SameLine();
        }
        first = false;
    };
    for (std::size_t i = 0; i < integrator_names.size(); ++i) {
        const auto integrator = static_cast<Integrator>(i);
        if (std::ranges::any_of(explorer.rows,
                                [&](const SweepRow& row) { return row.point.integrator == integrator; })) {
            next_to(10.0f * em());
            entry({integrator, 1, false, 1}, std::string(integrator_names[i]));
        }
    }
    next_to(10.0f * em());
    entry({Integrator::leapfrog, 1, true, 1}, "hollow: compensated");
    if (std::ranges::any_of(explorer.rows, [](const SweepRow& row) { return row.point.grid_reuse > 1; })) {
        next_to(12.0f * em());
        entry({Integrator::leapfrog, 1, false, 2}, "with a dot: a grid used again");
    }
}

std::vector<std::size_t> front_of(const ExplorerState& explorer) {
    std::vector<measure::Trade> trades;
    for (const SweepRow& row : explorer.rows) {
        trades.push_back({row.ms_a_second, shown_error(row, explorer.metric)});
    }
    return measure::pareto_front(trades);
}

LogPlot::Axes trade_axes(const ExplorerState& explorer) {
    std::vector<double> costs;
    std::vector<double> errors;
    for (const SweepRow& row : explorer.rows) {
        if (const auto error = shown_error(row, explorer.metric)) {
            costs.push_back(row.ms_a_second);
            errors.push_back(std::min(*error, 1e3));  // what has exploded stands at the upper edge
        }
    }
    if (explorer.budget) {
        errors.push_back(*explorer.budget);
    }
    if (explorer.metric == SweepMetric::position && explorer.float_floor > 0.0) {
        errors.push_back(explorer.float_floor);
    }
    return {decades_of(costs), decades_of(errors), false, "ms for a simulated second", metric_label(explorer.metric)};
}

void describe(const SweepRow& row) {
    std::string words = point_text(row.point) + "\n" + format("%.4g ms for a simulated second", row.ms_a_second) +
                        "\nposition " + value_text(row.position) + " m  ·  energy " + value_text(row.energy) +
                        " 1/s\noverlap " + value_text(row.overlap) + "  ·  restitution " + value_text(row.restitution);
    if (row.point.grid_reuse > 1) {
        words += format("\ncell factor %.3g", row.cell_factor) +
                 (row.missed ? ", contacts missed: " + grouped(*row.missed) : std::string());
    }
    words += row.note.empty() ? "\nClick: run the scene like this" : "\n" + row.note;
    tooltip(words);
}

// The row whose symbol is under the pointer.
const SweepRow* pointed_at(const ExplorerState& explorer, const LogPlot& plot) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const SweepRow* nearest = nullptr;
    float best = 0.8f * em();
    for (const SweepRow& row : explorer.rows) {
        if (const auto error = shown_error(row, explorer.metric)) {
            const ImVec2 at = plot.place(row.ms_a_second, *error);
            const float distance = std::hypot(at.x - mouse.x, at.y - mouse.y);
            if (distance < best) {
                best = distance;
                nearest = &row;
            }
        }
    }
    return nearest;
}

void draw_trade(const ExplorerState& explorer, const LogPlot& plot) {
    if (explorer.metric == SweepMetric::position && explorer.float_floor > 0.0) {
        plot.horizontal(explorer.float_floor, floor_colour, "what a float can tell apart");
    }
    if (explorer.budget) {
        plot.horizontal(*explorer.budget, budget_colour, "budget");
    }
    const auto front = front_of(explorer);
    const auto at = [&](std::size_t i) {
        const SweepRow& row = explorer.rows[i];
        return plot.place(row.ms_a_second, shown_error(row, explorer.metric).value_or(1.0));
    };
    for (std::size_t i = 1; i < front.size(); ++i) {
        plot.list()->AddLine(at(front[i - 1]), at(front[i]), front_colour, 1.5f);
    }
    for (std::size_t i = 0; i < explorer.rows.size(); ++i) {
        const SweepRow& row = explorer.rows[i];
        if (shown_error(row, explorer.metric)) {
            draw_symbol(plot.list(), at(i), 0.34f * em(), row.point);
        }
        if (row.point == explorer.here && shown_error(row, explorer.metric)) {
            plot.list()->AddCircle(at(i), 0.62f * em(), here_colour, 0, 2.0f);
            plot.list()->AddText(ImVec2(at(i).x + 0.7f * em(), at(i).y - 0.5f * em()), here_colour, "you are here");
        }
    }
}

// How the chosen row's positions depart from the reference, shaded where that says nothing any more.
void draw_departure(const ExplorerState& explorer, const SweepRow& row) {
    std::vector<double> errors;
    for (const double error : row.position_at) {
        errors.push_back(std::clamp(error, smallest_shown, 1e3));
    }
    const double end = static_cast<double>(row.position_at.size() - 1) * explorer.dt;
    const std::string label = "position error of " + point_text(row.point) + ", m";
    const LogPlot plot(
        "departure", ImVec2(ImGui::GetContentRegionAvail().x, 9.0f * em()),
        {{0.0, std::max(end, explorer.dt)}, decades_of(std::span(errors).subspan(1)), true, "time, s", label});
    for (std::size_t i = 2; i < errors.size(); ++i) {
        plot.list()->AddLine(plot.place(static_cast<double>(i - 1) * explorer.dt, errors[i - 1]),
                             plot.place(static_cast<double>(i) * explorer.dt, errors[i]), front_colour, 1.5f);
    }
    if (explorer.horizon_s && *explorer.horizon_s < end) {
        plot.shade_from(*explorer.horizon_s, unknowable);
        if (plot.hovered()) {
            tooltip(
                "Shaded: a run that began one rounding away would be as far off. Beyond, only what can be averaged "
                "counts.");
        }
    }
}

const SweepRow* row_here(const ExplorerState& explorer) {
    const auto found = std::ranges::find(explorer.rows, explorer.here, &SweepRow::point);
    return found == explorer.rows.end() ? nullptr : &*found;
}

}  // namespace

void explorer_panel(const State& state, Commands& commands) {
    const ExplorerState& explorer = *state.explorer;
    controls(explorer, commands);
    if (explorer.rows.empty()) {
        return;
    }
    metric_choice(explorer, commands);
    key_to_symbols(explorer);
    if (explorer.metric == SweepMetric::position && !explorer.note.empty()) {
        wrapped_text(explorer.note);
        return;
    }
    const bool departure = explorer.metric == SweepMetric::position;
    const float height = std::max(14.0f * em(), ImGui::GetContentRegionAvail().y - (departure ? 10.0f : 0.5f) * em());
    const LogPlot plot("trade", ImVec2(ImGui::GetContentRegionAvail().x, height), trade_axes(explorer));
    draw_trade(explorer, plot);
    const SweepRow* pointed = plot.hovered() ? pointed_at(explorer, plot) : nullptr;
    if (pointed != nullptr) {
        describe(*pointed);
        if (plot.clicked() && !explorer.stale) {
            commands.push_back(ChangeSettings{measure::with_row(state.settings, *pointed)});
        }
    }
    const SweepRow* shown = pointed != nullptr ? pointed : row_here(explorer);
    if (departure && shown != nullptr && shown->position_at.size() > 2) {
        draw_departure(explorer, *shown);
    }
}

void draw_explorer_window(const State& state, Commands& commands) {
    if (state.explorer == nullptr) {
        return;
    }
    const ImVec2 room = free_room(state);
    const float below_rate = 6.0f * em();
    const ImVec2 size(std::min(44.0f * em(), room.x), room.y - below_rate);
    if (!tool_window(state, "Speed and accuracy", ImVec2(window_margin(), below_rate), size,
                     [&] { explorer_panel(state, commands); })) {
        commands.push_back(Action::toggle_explorer);
    }
}

}  // namespace ballpit::ui
