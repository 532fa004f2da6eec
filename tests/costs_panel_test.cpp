// Cost against the number of balls on screen.
#include <array>
#include <variant>

#include "support/catch.h"
#include "support/headless_gui.h"
#include "ui/costs_panel.h"

using namespace ballpit;

namespace {

bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

const std::array<ui::SceneChoice, 1> scenes = {{{"Rain", "Balls fall."}}};

ui::CostLine line_of(const std::string& sort, double factor) {
    ui::CostLine line{sort, {}};
    for (const std::uint32_t balls : {1024u, 4096u, 16384u}) {
        line.points.push_back({sort, balls, factor * balls, {}});
    }
    return line;
}

struct Shown {
    ui::CostsState costs;
    ui::State state;

    Shown() {
        state.scenes = scenes;
        state.backend_name = "gpu";
        state.costs = &costs;
    }
};

std::string panel_text(test::HeadlessGui& gui, const ui::State& state) {
    return gui.text([&state] {
        ImGui::Dummy(ImVec2(900.0f, 1.0f));
        ui::Commands commands;
        ui::costs_panel(state, commands);
    });
}

template <class Wanted>
bool asks_for(test::HeadlessGui& gui, const Shown& shown) {
    gui.frame(shown.state);
    const ImGuiWindow* window = ImGui::FindWindowByName("Cost and number of balls");
    REQUIRE(window != nullptr);
    bool asked = false;
    for (float y = window->Pos.y + 2.0f * ui::em(); y < window->Pos.y + 6.0f * ui::em(); y += 0.5f * ui::em()) {
        for (const ui::Command& command : gui.click(shown.state, window->Pos.x + 2.0f * ui::em(), y)) {
            asked = asked || std::holds_alternative<Wanted>(command);
        }
    }
    return asked;
}

}  // namespace

TEST_CASE("a line of costs tells its sort, its last point and its slope", "[ui]") {
    CHECK(ui::cost_line_text({"bitonic", {}}) == "bitonic");
    const std::string words = ui::cost_line_text(line_of("bitonic", 1e-4));
    CHECK(contains(words, "bitonic: 1.64 ms at 16"));
    CHECK(contains(words, "slope 1.00"));
}

TEST_CASE("costs are measured on request, and the measuring can be stopped", "[ui]") {
    test::HeadlessGui gui;
    Shown shown;
    CHECK(contains(panel_text(gui, shown.state), "Measure this scene"));
    CHECK(asks_for<ui::StartCosts>(gui, shown));
    shown.costs.running = shown.costs.begun = true;
    CHECK(asks_for<ui::StopCosts>(gui, shown));
    CHECK_FALSE(asks_for<ui::StartCosts>(gui, shown));
}

TEST_CASE("a plot of costs says where the running scene stands", "[ui]") {
    test::HeadlessGui gui;
    Shown shown;
    shown.costs.begun = true;
    shown.costs.lines = {line_of("bitonic", 2e-4), line_of("bitonic_fused", 1e-4)};
    shown.costs.here_sort = "bitonic_fused";
    shown.costs.here_balls = 5000;
    const std::string words = panel_text(gui, shown.state);
    CHECK(contains(words, "bitonic_fused: 1.64 ms at 16"));
    CHECK(contains(words, "not touched"));
    shown.costs.stale = true;
    CHECK(contains(panel_text(gui, shown.state), "another one now"));
}

TEST_CASE("a scene that lists its balls has no other number of them", "[ui]") {
    test::HeadlessGui gui;
    Shown shown;
    shown.costs.possible = false;
    CHECK(contains(panel_text(gui, shown.state), "no other number"));
    CHECK_FALSE(asks_for<ui::StartCosts>(gui, shown));
}
