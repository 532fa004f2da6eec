// Speed against accuracy on screen: what is measured, where the scene stands, and what a click asks for.
#include <set>
#include <variant>

#include "support/catch.h"
#include "support/headless_gui.h"
#include "ui/explorer_panel.h"

using namespace ballpit;
using measure::SweepMetric;
using measure::SweepRow;

namespace {

bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

const std::array<ui::SceneChoice, 1> scenes = {{{"Rain", "Balls fall."}}};

SweepRow row_of(Integrator integrator, std::uint32_t substeps, double ms, double error) {
    SweepRow row;
    row.point = {integrator, substeps, false, 1};
    row.ms_a_second = ms;
    row.position = error;
    row.position_at = {0.0, 0.1 * error, 0.5 * error, error, 3.0 * error};
    row.energy = 0.1 * error;
    row.overlap = 0.05;
    row.restitution = 0.2 * error;
    return row;
}

struct Shown {
    std::vector<SweepRow> rows = {row_of(Integrator::leapfrog, 4, 10.0, 1e-2),
                                  row_of(Integrator::leapfrog, 16, 40.0, 1e-4),
                                  row_of(Integrator::historical, 16, 41.0, 1e-1)};
    ui::ExplorerState explorer;
    ui::State state;

    Shown() {
        state.scenes = scenes;
        state.backend_name = "gpu";
        state.explorer = &explorer;
        explorer.rows = rows;
        explorer.wanted = rows.size();
        explorer.seconds = 0.5;
        explorer.dt = 0.125;
        explorer.horizon_s = 0.3;
        explorer.here = {Integrator::leapfrog, 4, false};
    }
};

std::string panel_text(test::HeadlessGui& gui, const ui::State& state) {
    return gui.text([&state] {
        ImGui::Dummy(ImVec2(900.0f, 1.0f));
        ui::Commands commands;
        ui::explorer_panel(state, commands);
    });
}

// Everything that clicks over the window ask for.
ui::Commands clicked_everywhere(test::HeadlessGui& gui, const Shown& shown, float stride, bool* described = nullptr) {
    ui::Commands all;
    gui.frame(shown.state);
    const ImGuiWindow* window = ImGui::FindWindowByName("Speed and accuracy");
    REQUIRE(window != nullptr);
    const ImVec2 low = window->Pos;
    const ImVec2 size = window->Size;
    for (float y = low.y + 2.0f * ui::em(); y < low.y + size.y; y += stride) {
        for (float x = low.x + 0.5f * ui::em(); x < low.x + size.x - ui::em(); x += stride) {
            const ui::Commands more = gui.click(shown.state, x, y);
            const bool tip = gui.shows("##Tooltip_00");
            if (described != nullptr && !more.empty() && std::holds_alternative<ui::ChangeSettings>(more.front())) {
                *described = tip;
            }
            all.insert(all.end(), more.begin(), more.end());
        }
    }
    return all;
}

}  // namespace

TEST_CASE("before the first sweep the panel says what it would do, and a click begins it", "[ui]") {
    test::HeadlessGui gui;
    Shown shown;
    shown.explorer.rows = {};
    shown.explorer.wanted = 0;
    CHECK(contains(panel_text(gui, shown.state), "Measure this scene"));
    bool started = false;
    for (const ui::Command& command : clicked_everywhere(gui, shown, 14.0f)) {
        started |= std::holds_alternative<ui::StartSweep>(command);
    }
    CHECK(started);
}

TEST_CASE("a sweep that was stopped says what it has", "[ui]") {
    test::HeadlessGui gui;
    Shown shown;
    CHECK(contains(panel_text(gui, shown.state), "3 choices, each 0.5 s"));
    shown.explorer.wanted = 12;
    CHECK(contains(panel_text(gui, shown.state), "3 choices of 12, then it was ended, each 0.5 s"));
    shown.explorer.rows = {};
    CHECK(contains(panel_text(gui, shown.state), "Ended before the first choice was whole"));
}

TEST_CASE("while a sweep runs it shows how far it is and can be stopped", "[ui]") {
    test::HeadlessGui gui;
    Shown shown;
    shown.explorer.running = true;
    shown.explorer.wanted = 12;
    shown.explorer.seconds_left = 41.2;
    CHECK(contains(panel_text(gui, shown.state), "Stop"));
    bool stopped = false;
    for (const ui::Command& command : clicked_everywhere(gui, shown, 14.0f)) {
        stopped |= std::holds_alternative<ui::StopSweep>(command);
    }
    CHECK(stopped);
}

TEST_CASE("a click on a symbol runs the scene like that; every metric can be chosen", "[ui]") {
    test::HeadlessGui gui;
    Shown shown;
    std::set<std::pair<Integrator, std::uint32_t>> chosen;
    std::set<SweepMetric> metrics;
    bool described = false;
    for (const ui::Command& command : clicked_everywhere(gui, shown, 9.0f, &described)) {
        if (const auto* change = std::get_if<ui::ChangeSettings>(&command)) {
            chosen.insert({change->settings.integrator, change->settings.substeps});
        }
        if (const auto* metric = std::get_if<ui::ChooseMetric>(&command)) {
            metrics.insert(metric->metric);
        }
    }
    CHECK(chosen.size() == 3);
    CHECK(described);
    CHECK(metrics.size() == 4);
}

TEST_CASE("a sweep of another scene can be read, but not applied", "[ui]") {
    test::HeadlessGui gui;
    Shown shown;
    shown.explorer.stale = true;
    CHECK(contains(panel_text(gui, shown.state), "another one now"));
    for (const ui::Command& command : clicked_everywhere(gui, shown, 9.0f)) {
        CHECK_FALSE(std::holds_alternative<ui::ChangeSettings>(command));
    }
}

TEST_CASE("rows without an error, or with one of nothing or of infinity, disturb no plot", "[ui]") {
    test::HeadlessGui gui;
    Shown shown;
    shown.rows.push_back(row_of(Integrator::velocity_verlet, 1, 5.0, 0.0));
    shown.rows.push_back(row_of(Integrator::forward_euler, 1, 5.0, std::numeric_limits<double>::infinity()));
    shown.rows.back().energy.reset();
    shown.rows.back().restitution.reset();
    shown.explorer.rows = shown.rows;
    for (const SweepMetric metric :
         {SweepMetric::position, SweepMetric::energy, SweepMetric::overlap, SweepMetric::restitution}) {
        for (const ImVec2 size : {ImVec2(1280.0f, 720.0f), ImVec2(320.0f, 200.0f)}) {
            shown.explorer.metric = metric;
            ImGui::GetIO().DisplaySize = size;
            CHECK(gui.frame(shown.state).empty());
        }
    }
    shown.state.explorer = nullptr;
    gui.frame(shown.state);
    CHECK_FALSE(gui.shows("Speed and accuracy"));
}

TEST_CASE("why positions are not compared stands where their plot would be", "[ui]") {
    test::HeadlessGui gui;
    Shown shown;
    shown.explorer.metric = SweepMetric::position;
    shown.explorer.note = "Positions are not compared: too many balls.";
    CHECK(contains(panel_text(gui, shown.state), "too many balls"));
}

TEST_CASE("axes hold all values, in whole decades", "[ui]") {
    CHECK(ui::decades_of({}) == ui::Decades{-3.0, 0.0});
    const std::vector<double> values = {0.003, 20.0, 0.0, std::numeric_limits<double>::infinity()};
    CHECK(ui::decades_of(values) == ui::Decades{-3.0, 2.0});
    CHECK(ui::point_text({Integrator::historical, 1, true, 1}) == "historical, 1 substep, compensated");
    CHECK(ui::point_text({Integrator::leapfrog, 16, false, 8}) == "leapfrog, 16 substeps, one grid for 8 substeps");
    CHECK(ui::value_text(std::nullopt) == "–");
    CHECK(ui::value_text(0.00123) == "0.00123");
}
