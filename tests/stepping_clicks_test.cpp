// Strip and microscope drawn: where the run stands, and what a click asks for.
#include <set>
#include <variant>

#include "measure/sort_pass.h"
#include "support/catch.h"
#include "support/headless_gui.h"
#include "support/stepping_stage.h"
#include "ui/microscope.h"
#include "ui/stepping_panels.h"

using namespace ballpit;
using test::schedule_of;
using test::StripStage;

namespace {

bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("the strip tells where the run stands, and in red where a replay differed", "[stepping-ui]") {
    test::HeadlessGui gui;
    StripStage stage(5);
    const auto text = [&] {
        return gui.text([&] {
            ImGui::Dummy(ImVec2(880.0f, 1.0f));
            ui::Commands commands;
            ui::stepper_strip(stage.state, commands);
        });
    };
    CHECK(contains(text(), "Step 12, substep 2 of 4, dispatch 5 of 40"));
    CHECK(contains(text(), "on its way"));
    stage.stepping.hash = 0x0123456789ABCDEFull;
    stage.stepping.check.mode = ui::LiveCheckMode::mirror;
    stage.stepping.check.ms = 12.5;
    CHECK(contains(text(), "0123456789abcdef"));
    CHECK(contains(text(), "12.5 ms"));
    stage.stepping.check.mirror_computes = true;
    CHECK(contains(text(), "the mirror computes"));
}

TEST_CASE("clicks on the strip lead to every dispatch, substep, unit and direction", "[stepping-ui]") {
    test::HeadlessGui gui;
    StripStage stage(5);
    stage.stepping.check.mode = ui::LiveCheckMode::mirror;
    stage.state.view.panels = false;
    std::set<std::uint32_t> dispatches;
    std::set<std::uint32_t> substeps;
    std::set<ui::Action> actions;
    std::set<StepUnit> units;
    std::set<Stage> differences;
    const float top = 720.0f - ui::font_height * 14.0f;
    for (float y = top; y < 712.0f; y += 5.0f) {
        for (float x = 12.0f; x < 1270.0f; x += 7.0f) {
            for (const ui::Command& command : gui.click(stage.state, x, y)) {
                if (const auto* go = std::get_if<ui::GoTo>(&command)) {
                    CHECK(go->place.ran <= stage.schedule.dispatches.size());
                    CHECK(go->place.substep.step <= stage.stepping.furthest_step);
                    if (go->place.substep == stage.stepping.place.substep) {
                        dispatches.insert(go->place.ran);
                    }
                    substeps.insert(go->place.substep.substep);
                } else if (const auto* action = std::get_if<ui::Action>(&command)) {
                    actions.insert(*action);
                } else if (const auto* unit = std::get_if<ui::ChooseUnit>(&command)) {
                    units.insert(unit->unit);
                } else if (const auto* shown = std::get_if<ui::ShowDifferences>(&command)) {
                    differences.insert(*shown->stage);
                }
            }
        }
    }
    CHECK(dispatches.size() >= stage.schedule.dispatches.size());
    CHECK(substeps == std::set<std::uint32_t>{0, 1, 2, 3});
    CHECK(units.size() == 4);
    CHECK(differences.size() == 4);
    using ui::Action;
    CHECK(actions == std::set<Action>{Action::forward, Action::back, Action::step_start, Action::step_end});
}

TEST_CASE("clicks in the microscope select balls and go to passes", "[stepping-ui]") {
    test::HeadlessGui gui;
    for (const std::uint32_t slots : {16u, 64u, 0u}) {
        StripStage stage(5);
        stage.state.view.stepper = false;
        stage.state.view.microscope = true;
        stage.state.view.microscope_options.slots = slots;
        stage.state.view.panels = false;
        std::set<std::uint32_t> balls;
        std::set<std::uint32_t> passes;
        for (float y = 390.0f; y < 712.0f; y += 9.0f) {
            for (float x = 14.0f; x < 1266.0f; x += 11.0f) {
                for (const ui::Command& command : gui.click(stage.state, x, y)) {
                    if (const auto* select = std::get_if<ui::SelectBall>(&command)) {
                        CHECK(select->fly);
                        CHECK(select->ball.value_or(SENTINEL) < 200);
                        balls.insert(select->ball.value_or(SENTINEL));
                    } else if (const auto* go = std::get_if<ui::GoTo>(&command)) {
                        passes.insert(go->place.ran);
                    }
                }
            }
        }
        CAPTURE(slots);
        CHECK(balls.size() >= (slots == 0 ? 60u : slots));
        CHECK(passes.size() == measure::pass_count(stage.schedule.key_count));
    }
}

TEST_CASE("every view can be open at once, at every place, and with no balls", "[stepping-ui]") {
    test::HeadlessGui gui;
    for (const std::uint32_t balls : {0u, 1u, 3u, 200u}) {
        StripStage stage(0);
        stage.schedule = schedule_of(balls);
        stage.state.view.microscope = true;
        stage.stepping.check.mode = ui::LiveCheckMode::mirror;
        stage.stepping.divergence = Divergence{412, 73};
        stage.keys.assign(stage.schedule.key_count, Key{0, 0});
        stage.before = stage.keys;
        stage.inspection.slots[static_cast<std::size_t>(Slot::keys)].bytes = std::as_bytes(std::span(stage.keys));
        stage.inspection.keys_before = std::as_bytes(std::span(stage.before));
        for (std::uint32_t ran = 0; ran <= stage.schedule.dispatches.size(); ++ran) {
            stage.stepping.place.ran = ran;
            stage.stepping.check.shown = ran % 2 == 0 ? std::optional(Stage::assign_cells) : std::nullopt;
            CHECK(gui.frame(stage.state).empty());
            CHECK(gui.shows("stepper"));
            CHECK(gui.shows("Bitonic sort") != gui.shows("Differences"));
        }
    }
}

TEST_CASE("differences: GPU, CPU and how far apart; a click shows the ball", "[stepping-ui]") {
    test::HeadlessGui gui;
    StripStage stage(1);
    const std::vector<Key> gpu = {{0, 0}, {7, 1}, {9, 2}};
    const std::vector<Key> cpu = {{0, 0}, {61204, 1}, {9, 2}};
    const std::vector<std::uint32_t> differing = {1};
    ui::LiveCheckState& check = stage.stepping.check;
    check.mode = ui::LiveCheckMode::mirror;
    check.shown = Stage::assign_cells;
    check.stages[0] = {true, true, 3, 1, 1, 0, 0.0, "assign_cells, slot 1: GPU (7, 1), CPU (61204, 1)", {}, {}};
    check.stages[0].differences.push_back(
        {Slot::keys, "assign_cells", std::as_bytes(std::span(gpu)), std::as_bytes(std::span(cpu)), differing});
    const std::string text = gui.text([&] {
        ui::Commands commands;
        ui::differences_panel(stage.state, commands);
    });
    for (const char* part : {"GPU", "CPU", "61204", "-61197", "■ 1 differs"}) {
        INFO(part << " in " << text);
        CHECK(contains(text, part));
    }
    std::set<std::uint32_t> balls;
    bool closed = false;
    for (float y = 300.0f; y < 560.0f; y += 6.0f) {
        for (const ui::Command& command : gui.click(stage.state, 40.0f, y)) {
            if (const auto* select = std::get_if<ui::SelectBall>(&command)) {
                balls.insert(select->ball.value_or(SENTINEL));
            }
            closed = closed || std::holds_alternative<ui::ShowDifferences>(command);
        }
    }
    CHECK(balls == std::set<std::uint32_t>{1});
    CHECK(closed);
}
