// The window of meters: what it says, and what a click on it asks for.
#include "ui/meters_panel.h"

#include <limits>
#include <variant>

#include "support/catch.h"
#include "support/headless_gui.h"
#include "ui/meters_plot.h"

using namespace ballpit;

namespace {

bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

const std::array<ui::SceneChoice, 1> scenes = {{{"Rain", "Balls fall."}}};

struct Shown {
    std::vector<measure::Balance> series;
    ui::MetersState meters;
    ui::State state;

    Shown() {
        state.scenes = scenes;
        state.settings.laws = parse_laws("gravity,contact,walls");
        state.backend_name = "gpu";
        state.meters = &meters;
    }

    void fill() {
        MeterRecord record;
        record.time = 2.0;
        record.gravity = {0, 0, -9.8};
        record.reading.mass = 10.0;
        record.reading.floor_force = 49.0;
        record.reading.contact_ends = 24.0;
        record.reading.wall_contacts = 3.0;
        measure::Balance balance;
        for (int i = 0; i <= 20; ++i) {
            balance.time = 0.1 * i;
            balance.kinetic = 5.0 + i;
            balance.potential = -2.0 * i;
            balance.contact_heat = 0.5 * i;
            balance.start = 5.0;
            series.push_back(balance);
        }
        meters.record = record;
        meters.balance = balance;
        meters.series = series;
        meters.ms = 0.125;
        measure::Gauge good{"v dt / D", "", 0.1, 0.25, 0.5, false, "How far.", std::nullopt};
        measure::Gauge beyond{"dt / dt_c", "", 1.5, 0.5, 0.9, false, "How stiff.", measure::Remedy{"substeps", "24"}};
        meters.gauges = {beyond, good};
    }
};

std::string panel_text(test::HeadlessGui& gui, const ui::State& state) {
    return gui.text([&state] {
        ImGui::Dummy(ImVec2(700.0f, 1.0f));
        ui::Commands commands;
        ui::meters_panel(state, commands);
    });
}

}  // namespace

TEST_CASE("the meters say what has arrived, and that nothing has", "[ui]") {
    test::HeadlessGui gui;
    Shown shown;
    CHECK(contains(panel_text(gui, shown.state), "Waiting for the first substep"));
    shown.fill();
    const std::string text = panel_text(gui, shown.state);
    for (const char* part : {"0.125 ms", "kinetic", "25 J", "unexplained", "-10 J", "12 and 3", "49 N", "98 N",
                             "98 N: 50.0 %", "beyond", "dt / dt_c", "good", "substeps = 24"}) {
        INFO(part << " in\n" << text);
        CHECK(contains(text, part));
    }
    shown.meters.record->reading.mass = 0.0;
    CHECK(contains(panel_text(gui, shown.state), "No balls"));
}

TEST_CASE("the button of a gauge sets what turns it green, the cross closes the window", "[ui]") {
    test::HeadlessGui gui;
    Shown shown;
    shown.fill();
    for (int i = 0; i < 3; ++i) {
        gui.frame(shown.state);
    }
    const ImGuiWindow* window = ImGui::FindWindowByName("Meters");
    REQUIRE(window != nullptr);
    REQUIRE(window->Active);
    bool set = false;
    bool anew = false;
    for (float y = window->Pos.y + 2.0f * ui::em(); y < window->Pos.y + window->Size.y; y += 7.0f) {
        for (const float x : {2.0f, 18.0f}) {
            for (const ui::Command& command : gui.click(shown.state, window->Pos.x + x * ui::em(), y)) {
                const auto* change = std::get_if<ui::ChangeSettings>(&command);
                set |= change != nullptr && change->settings.substeps == 24;
                anew |= std::holds_alternative<ui::RestartMeters>(command);
            }
        }
    }
    CHECK(set);
    CHECK(anew);
    bool closed = false;
    const float x = window->Pos.x + window->Size.x - 0.8f * ui::em();
    for (const ui::Command& command : gui.click(shown.state, x, window->Pos.y + 0.7f * ui::em())) {
        const auto* action = std::get_if<ui::Action>(&command);
        closed |= action != nullptr && *action == ui::Action::toggle_meters;
    }
    CHECK(closed);
    shown.state.meters = nullptr;
    gui.frame(shown.state);
    CHECK_FALSE(gui.shows("Meters"));
}

TEST_CASE("bands are never negative, whatever a run has come to", "[ui]") {
    measure::Balance balance;
    balance.kinetic = std::numeric_limits<double>::quiet_NaN();
    balance.potential = -3.0;
    balance.wall_heat = -1.0;
    const std::array series{balance};
    CHECK(ui::lowest_potential(series) == -3.0);
    for (const double band : ui::bands_of(balance, -3.0)) {
        CHECK(band == 0.0);
    }
    balance.potential = 1.0;
    CHECK(ui::bands_of(balance, -3.0)[1] == 4.0);
}
