// The error budget on screen: what the probe measured, what would do, and what a click asks for.
#include "ui/budget_panel.h"

#include <set>

#include "core/random.h"
#include "support/catch.h"
#include "support/headless_gui.h"

using namespace ballpit;

namespace {

bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

struct Shown {
    ui::State state;
    ui::BudgetState budget;

    Shown() {
        state.budget = &budget;
        state.settings.substeps = 8;
        measure::ProbeResult probe;
        probe.groups.resize(2);
        probe.groups[0].speed = 1.25;
        probe.groups[0].restitution = {0.75, 0.74, 0.01, 0.7123, 0.03};
        probe.groups[1].wall = true;
        probe.groups[1].speed = 2.5;
        probe.substeps_a_contact = 9.5;
        budget.probe = probe;
        measure::BudgetChoice choice;
        choice.substeps = 24;
        choice.integrator = Integrator::velocity_verlet;
        budget.choice = choice;
        budget.sentence = "24 substeps do it";
    }

    std::string text(test::HeadlessGui& gui) const {
        return gui.text([this] {
            ui::Commands commands;
            ImGui::BeginChild("content", ImVec2(900.0f, 700.0f));
            ui::budget_panel(state, commands);
            ImGui::EndChild();
        });
    }
};

}  // namespace

TEST_CASE("the budget's window says what was measured, beside what is exact", "[ui]") {
    test::HeadlessGui gui;
    Shown shown;
    const std::string words = shown.text(gui);
    for (const char* part : {"24 substeps do it.", "Apply 24 substeps", "9.5 of them a contact", "Two balls, 1.25 m/s",
                             "Ball and wall, 2.5 m/s", "0.75000", "0.71230", "0.03000"}) {
        INFO(part);
        CHECK(contains(words, part));
    }
    CHECK(contains(words, "known once the scene has run"));
    shown.budget.substep_ms = 0.5;
    CHECK(contains(shown.text(gui), "0.5 ms a substep: 12 ms for 24, 4 ms for the 8 of now"));
    shown.budget.probe->groups[0].overlap.exact = 1.2;
    CHECK(contains(shown.text(gui), "pass through"));
    shown.budget.probe->nothing = "nothing touches";
    CHECK(contains(shown.text(gui), "nothing touches."));
    CHECK_FALSE(contains(shown.text(gui), "Two balls"));
    shown.budget.choice.reset();
    shown.budget.measuring = true;
    CHECK(contains(shown.text(gui), "measuring"));
}

TEST_CASE("clicks in the budget's window choose presets, allow errors and apply the count", "[ui]") {
    test::HeadlessGui gui;
    Shown shown;
    shown.state.view.panels = false;
    std::set<double> presets;
    bool historical = false;
    bool typed = false;
    bool applied = false;
    for (std::uint64_t i = 0; i < 1200; ++i) {
        const auto x = static_cast<float>(800.0 * random_unit(2, 0, i));
        const auto y = static_cast<float>(90.0 + 300.0 * random_unit(2, 1, i));
        for (const ui::Command& command : gui.click(shown.state, x, y)) {
            if (const auto* change = std::get_if<ui::ChangeBudget>(&command)) {
                const measure::ErrorBudget& allowed = change->options.budget;
                const bool equal = allowed.restitution == allowed.overlap && allowed.overlap == allowed.energy;
                CHECK(allowed.restitution >= ui::least_allowed);
                CHECK(allowed.restitution <= ui::most_allowed);
                presets.insert(equal ? allowed.restitution : 0.0);
                historical |= change->options.historical;
                typed |= !equal;
            } else if (const auto* settings = std::get_if<ui::ChangeSettings>(&command)) {
                CHECK(settings->settings.substeps == 24);
                CHECK(settings->settings.integrator == Integrator::velocity_verlet);
                applied = true;
            }
        }
    }
    CHECK(presets.contains(0.1));
    CHECK(presets.contains(0.01));
    CHECK(presets.contains(0.001));
    CHECK(historical);
    CHECK(typed);
    CHECK(applied);
    shown.budget.applied = true;
    for (float y = 90.0f; y < 390.0f; y += 5.0f) {
        for (const ui::Command& command : gui.click(shown.state, 100.0f, y)) {
            CHECK_FALSE(std::holds_alternative<ui::ChangeSettings>(command));
        }
    }
    shown.state.budget = nullptr;
    gui.frame(shown.state);
    CHECK_FALSE(gui.shows("Error budget"));
}
