#include "ui/costs_panel.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/log_plot.h"
#include "ui/tool_window.h"
#include "ui/widgets.h"

namespace ballpit::ui {

namespace {

using measure::CostPoint;

const ImU32 here_colour = packed(vec3(1.0f, 1.0f, 1.0f));

// Okabe and Ito's, one a sort; the number of corners says the same.
const std::array<ImU32, 6> colours = {packed(vec3(0.34f, 0.71f, 0.91f)), packed(vec3(0.90f, 0.62f, 0.00f)),
                                      packed(vec3(0.00f, 0.62f, 0.45f)), packed(vec3(0.80f, 0.47f, 0.65f)),
                                      packed(vec3(0.94f, 0.89f, 0.26f)), packed(vec3(0.84f, 0.37f, 0.00f))};
constexpr std::array<int, 6> corners = {16, 4, 3, 5, 6, 8};

void draw_mark(ImDrawList* list, ImVec2 at, float radius, std::size_t line) {
    list->AddNgonFilled(at, radius, colours.at(line % colours.size()), corners.at(line % corners.size()));
}

std::string ms_text(double ms) { return format("%.3g ms", ms); }

void controls(const CostsState& costs, Commands& commands) {
    if (costs.running) {
        if (ImGui::Button("Stop")) {
            commands.push_back(StopCosts{});
        }
        tooltip("What was measured so far stays.");
        ImGui::SameLine();
        ImGui::ProgressBar(static_cast<float>(costs.progress), ImVec2(-1.0f, 0.0f));
        return;
    }
    if (!costs.possible) {
        wrapped_text("This scene lists its balls one by one: there is no other number of them to measure.");
        return;
    }
    if (ImGui::Button(costs.begun ? "Measure again" : "Measure this scene")) {
        commands.push_back(StartCosts{});
    }
    ImGui::SameLine();
    wrapped_dim_text(costs.stale   ? "The scene is another one now than when this was measured."
                     : costs.begun ? "A substep of copies of this scene from its start; the running one is not touched."
                                   : "Runs copies of the scene with more and more balls and every sort, until a "
                                     "substep takes too long.");
}

LogPlot::Axes axes_of(const CostsState& costs) {
    std::vector<double> counts;
    std::vector<double> times;
    for (const CostLine& line : costs.lines) {
        for (const CostPoint& point : line.points) {
            counts.push_back(point.balls);
            times.push_back(point.ms);
        }
    }
    return {decades_of(counts), decades_of(times), false, "balls", "ms a substep"};
}

void legend(const CostsState& costs) {
    for (std::size_t i = 0; i < costs.lines.size(); ++i) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        draw_mark(ImGui::GetWindowDrawList(), ImVec2(at.x + 0.5f * em(), at.y + 0.55f * em()), 0.32f * em(), i);
        ImGui::Dummy(ImVec2(em(), em()));
        ImGui::SameLine();
        text(cost_line_text(costs.lines[i]));
    }
}

void describe(const CostPoint& point) {
    std::string words = point.sort + ", " + grouped(point.balls) + " balls: " + ms_text(point.ms);
    for (std::size_t stage = 0; stage < stage_count; ++stage) {
        words += "\n" + std::string(stage_names[stage]) + ": " + ms_text(point.stage_ms[stage]);
    }
    tooltip(words);
}

void draw_lines(const CostsState& costs, const LogPlot& plot) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const CostPoint* pointed = nullptr;
    for (std::size_t i = 0; i < costs.lines.size(); ++i) {
        const std::vector<CostPoint>& points = costs.lines[i].points;
        for (std::size_t p = 0; p < points.size(); ++p) {
            const ImVec2 at = plot.place(points[p].balls, points[p].ms);
            if (p > 0) {
                plot.list()->AddLine(plot.place(points[p - 1].balls, points[p - 1].ms), at, colours.at(i % 6), 1.5f);
            }
            draw_mark(plot.list(), at, 0.34f * em(), i);
            if (plot.hovered() && std::hypot(at.x - mouse.x, at.y - mouse.y) < 0.8f * em()) {
                pointed = &points[p];
            }
        }
    }
    if (pointed != nullptr) {
        describe(*pointed);
    }
}

void draw_here(const CostsState& costs, const LogPlot& plot) {
    for (const CostLine& line : costs.lines) {
        const auto ms = measure::cost_at(line.points, costs.here_balls);
        if (line.sort == costs.here_sort && ms) {
            const ImVec2 at = plot.place(costs.here_balls, *ms);
            plot.list()->AddCircle(at, 0.62f * em(), here_colour, 0, 2.0f);
            plot.list()->AddText(ImVec2(at.x + 0.7f * em(), at.y + 0.1f * em()), here_colour, "you are here");
        }
    }
}

}  // namespace

std::string cost_line_text(const CostLine& line) {
    std::string words = line.sort;
    if (!line.points.empty()) {
        const CostPoint& last = line.points.back();
        words += ": " + ms_text(last.ms) + " at " + grouped(last.balls) + " balls";
    }
    if (const auto exponent = measure::slope(line.points)) {
        words += format(", slope %.2f", *exponent);
    }
    return words;
}

void costs_panel(const State& state, Commands& commands) {
    const CostsState& costs = *state.costs;
    controls(costs, commands);
    if (std::ranges::all_of(costs.lines, [](const CostLine& line) { return line.points.empty(); })) {
        return;
    }
    legend(costs);
    const float height = std::max(14.0f * em(), ImGui::GetContentRegionAvail().y - 0.5f * em());
    const LogPlot plot("cost", ImVec2(ImGui::GetContentRegionAvail().x, height), axes_of(costs));
    draw_lines(costs, plot);
    draw_here(costs, plot);
}

void draw_costs_window(const State& state, Commands& commands) {
    if (state.costs == nullptr) {
        return;
    }
    const ImVec2 room = free_room(state);
    const float below_rate = 6.0f * em();
    const ImVec2 size(std::min(40.0f * em(), room.x), std::min(34.0f * em(), room.y - below_rate));
    if (!tool_window(state, "Cost and number of balls", ImVec2(window_margin(), below_rate), size,
                     [&] { costs_panel(state, commands); })) {
        commands.push_back(Action::toggle_costs);
    }
}

}  // namespace ballpit::ui
