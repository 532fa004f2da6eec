// The panels as a user meets them: what can be read, and what every click asks for.
#include <array>
#include <bit>
#include <set>
#include <variant>

#include "core/error.h"
#include "core/random.h"
#include "support/catch.h"
#include "support/headless_gui.h"
#include "ui/action.h"
#include "ui/setting_row.h"
#include "ui/status_panel.h"

using namespace ballpit;

namespace {

const std::array<ui::SceneChoice, 3> scenes = {
    {{"Rain", "Balls fall."}, {"Two balls", "They meet."}, {"Gas", "No gravity."}}};

vec3 grey(float amount) { return vec3(amount); }

const ui::PlayState play;

ui::State full_state() {
    ui::State state;
    state.play = &play;
    state.scenes = scenes;
    state.settings.balls = state.defaults.balls = 5000;
    for (const LawInfo& law : law_table()) {
        state.settings.laws.*law.member = true;
    }
    state.backend_name = "gpu";
    state.amount_colour = grey;
    return state;
}

std::string settings_text(test::HeadlessGui& gui, const ui::State& state) {
    return gui.text([&state] {
        ImGui::GetStateStorage()->SetInt(ImGui::GetID("Computing"), 1);  // folded at first
        ui::Commands commands;
        ui::settings_panel(state, commands);
    });
}

bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

void check_settings(const Settings& settings) {
    for (const SettingInfo& info : setting_table()) {
        Settings parsed;  // what the command line refuses, a slider must not give
        CHECK_NOTHROW(assign_setting(parsed, info.key, setting_text(info, settings)));
    }
}

}  // namespace

TEST_CASE("every setting of a law that the scene has is on the panel, and no other", "[ui]") {
    test::HeadlessGui gui;
    ui::State state = full_state();
    const std::string all = settings_text(gui, state);
    for (const SettingInfo& info : setting_table()) {
        INFO(info.label);
        CHECK(contains(all, info.label) == ui::has_row(info));
    }
    state.settings.laws = {};
    const std::string few = settings_text(gui, state);
    CHECK(contains(few, "Balls"));
    CHECK(contains(few, "Substeps"));
    for (const char* absent : {"Gravity", "Drag", "Stiffness", "Restitution", "Cell factor", "Sort"}) {
        INFO(absent);
        CHECK_FALSE(contains(few, absent));
    }
}

TEST_CASE("where a grid is used again, the panel says how far balls go and how wide cells should be", "[ui]") {
    test::HeadlessGui gui;
    ui::State state = full_state();
    state.largest_radius = 0.1;
    state.cell_width = 0.21;
    state.status.drift_bits = std::bit_cast<std::uint32_t>(0.0016f);  // m^2: 40 mm
    CHECK_FALSE(contains(settings_text(gui, state), "while a grid was used"));
    state.settings.grid_reuse = 4;
    const std::string words = settings_text(gui, state);
    CHECK(contains(words, "40 mm"));
    CHECK(contains(words, "10 mm"));
    CHECK(contains(words, "Cell factor 1.25"));
    state.settings.cell_factor = 1.25;
    CHECK_FALSE(contains(settings_text(gui, state), "Cell factor 1.25"));
    state.has_grid = false;
    CHECK_FALSE(contains(settings_text(gui, state), "while a grid was used"));
}

TEST_CASE("values show their units, and a changed one its way back", "[ui]") {
    test::HeadlessGui gui;
    ui::State state = full_state();
    state.settings.stiffness = state.defaults.stiffness = 100000.0;
    const std::string unchanged = settings_text(gui, state);
    CHECK(contains(unchanged, "100000 N/m"));
    CHECK_FALSE(contains(unchanged, "↺"));
    state.settings.stiffness = 5.0;
    const std::string changed = settings_text(gui, state);
    CHECK(contains(changed, "5 N/m"));
    CHECK(contains(changed, "↺"));
}

TEST_CASE("the help page names every key beside its meaning", "[ui]") {
    test::HeadlessGui gui;
    ui::State state = full_state();
    const std::string page = gui.text([&state] {
        ui::Commands commands;
        ui::help_page(state, commands);
    });
    for (const ui::KeyRow& row : ui::key_table()) {
        INFO(row.meaning);
        CHECK(contains(page, row.meaning));
    }
    for (const ui::CameraRow& row : ui::camera_table()) {
        CHECK(contains(page, row.meaning));
    }
}

TEST_CASE("hidden panels leave only what went wrong", "[ui]") {
    test::HeadlessGui gui;
    ui::State state = full_state();
    state.view.occupancy = state.view.timings = true;
    gui.frame(state);
    for (const char* window : {"frame rate", "controls", "occupancy", "timings"}) {
        INFO(window);
        CHECK(gui.shows(window));
    }
    state.view.panels = false;
    state.message = "No OpenGL 4.3 here.";
    state.status.bits = STATUS_NOT_FINITE;
    gui.frame(state);
    for (const char* window : {"frame rate", "controls", "occupancy", "timings", "help"}) {
        INFO(window);
        CHECK_FALSE(gui.shows(window));
    }
    CHECK(gui.shows("message"));
    CHECK(gui.shows("status"));
    state.message = {};
    state.status = {};
    state.view.help = true;
    gui.frame(state);
    CHECK_FALSE(gui.shows("message"));
    CHECK_FALSE(gui.shows("status"));
    CHECK(gui.shows("help"));
}

TEST_CASE("a failure is told with its stage and its count", "[ui]") {
    CHECK(ui::extreme_sentences({}, true).empty());
    Status all{};
    all.bits = STATUS_NOT_FINITE | STATUS_OUT_OF_BOUNDS | STATUS_OVER_CAPACITY | STATUS_MISSED;
    all.not_finite = 1;
    all.out_of_bounds = 2000;
    all.over_capacity = 3;
    all.missed = 7;
    ExtremeNumbers numbers = counted_extremes(all);
    numbers[Extreme::hitches] = 4.0;
    const auto sentences = ui::extreme_sentences(numbers, true);
    REQUIRE(sentences.size() == 4);
    CHECK(contains(sentences[0], "collide"));
    CHECK(contains(sentences[0], ": 1 balls."));
    CHECK(contains(sentences[1], "assign_cells"));
    CHECK(contains(sentences[1], ": 2000 times."));
    CHECK(contains(sentences[2], "build_grid"));
    CHECK(contains(sentences[3], "count_missed"));
    CHECK(contains(sentences[3], ": 7 times."));
    CHECK(ui::extreme_sentences(numbers, false).size() == 1);  // no alarm
}

TEST_CASE("a warning has its number, and buttons for what helps", "[ui]") {
    test::HeadlessGui gui;
    ui::State state = full_state();
    gui.frame(state);
    CHECK_FALSE(gui.shows("warnings"));
    state.extremes[Extreme::explicit_dashpot_limit] = 1.25;
    state.extremes[Extreme::initial_overlap] = 9e5;
    std::set<std::size_t> kinds;
    ui::Commands commands;
    for (float y = 10.0f; y < 700.0f; y += 8.0f) {
        for (const float x : {30.0f, 75.0f, 180.0f}) {
            for (const ui::Command& command : gui.click(state, x, y)) {
                kinds.insert(command.index());
            }
        }
    }
    CHECK(gui.shows("warnings"));
    const std::string text = gui.text([&] { ui::warnings_panel(state, commands); });
    CHECK(contains(text, "1.25"));
    CHECK(contains(text, "9e+05 J"));
    CHECK(kinds == std::set<std::size_t>{ui::Command(ui::ChangeSettings{}).index(),
                                         ui::Command(ui::RelaxOverlaps{}).index(),
                                         ui::Command(ui::HideWarnings{}).index()});
}

TEST_CASE("overlays say what they know", "[ui]") {
    test::HeadlessGui gui;
    ui::State state = full_state();
    const auto occupancy_text = [&] { return gui.text([&state] { ui::occupancy_panel(state); }); };
    CHECK(contains(occupancy_text(), "Waiting"));
    measure::Occupancy occupancy;
    occupancy.histogram = {10, 5, 2, 0, 1};
    occupancy.occupied = 8;
    occupancy.max = 4;
    occupancy.mean_occupied = 1.75;
    state.occupancy = &occupancy;
    CHECK(contains(occupancy_text(), "mean 1.75"));
    state.has_grid = false;
    CHECK(contains(occupancy_text(), "no contacts"));

    const std::array<float, 3> history = {1.0f, 2.0f, 4.0f};
    const std::array<ui::TimingRow, 2> rows = {
        {{"collide", "substep", vec3(1.0f), 4.0, 2.0, history}, {"drawing", "frame", vec3(1.0f), 0.0, 0.0, {}}}};
    state.timings = rows;
    const std::string timings = gui.text([&state] { ui::timings_panel(state); });
    for (const char* part : {"collide", "4.00", "2.00", "substep", "drawing", "frame"}) {
        INFO(part);
        CHECK(contains(timings, part));
    }
}

TEST_CASE("slow motion is told, real time is not complained about", "[ui]") {
    test::HeadlessGui gui;
    ui::State state = full_state();
    const auto text = [&] { return gui.text([&state] { ui::frame_rate_panel(state); }); };
    CHECK(contains(text(), "paused"));
    state.running = true;
    state.achieved = 0.97;
    CHECK(contains(text(), "real time"));
    CHECK_FALSE(contains(text(), "slow motion"));
    state.achieved = 0.25;
    CHECK(contains(text(), "slow motion: 0.25 × real time"));
}

TEST_CASE("nobody touches anything: nothing is asked for", "[ui]") {
    test::HeadlessGui gui;
    const ui::State state = full_state();
    for (int i = 0; i < 10; ++i) {
        CHECK(gui.frame(state).empty());
    }
}

// Clicks all over the side panel. The state never changes, so each command shows what one click does.
TEST_CASE("whatever is clicked asks for something that can be had, and every control is reached", "[ui]") {
    test::HeadlessGui gui(ImVec2(1280.0f, 1080.0f));  // high enough for what would be scrolled to
    ui::State state = full_state();
    std::set<std::size_t> kinds;
    std::set<ui::Action> actions;
    for (std::uint64_t i = 0; i < 14000; ++i) {
        const auto x = static_cast<float>(900.0 + 380.0 * random_unit(3, 0, i));
        const auto y = static_cast<float>(1080.0 * random_unit(3, 1, i));
        state.settings.stiffness = i % 2 == 0 ? 1000.0 : 500.0;  // so that there is a value to reset
        for (const ui::Command& command : gui.click(state, x, y)) {
            kinds.insert(command.index());
            if (const auto* action = std::get_if<ui::Action>(&command)) {
                actions.insert(*action);
            } else if (const auto* change = std::get_if<ui::ChangeSettings>(&command)) {
                check_settings(change->settings);
            } else if (const auto* scene = std::get_if<ui::ChooseScene>(&command)) {
                CHECK(scene->index < scenes.size());
            } else if (const auto* speed = std::get_if<ui::ChangeSpeed>(&command)) {
                CHECK(speed->speed >= ui::slowest_time);
                CHECK(speed->speed <= ui::fastest_time);
            }
        }
    }
    const auto reached = [&kinds](const ui::Command& command) { return kinds.count(command.index()) == 1; };
    CHECK(reached(ui::ChangeSettings{}));
    CHECK(reached(ui::ChooseScene{}));
    CHECK(reached(ui::ChooseBackend{}));
    CHECK(reached(ui::ChangeSpeed{}));
    CHECK(reached(ui::ChangeView{}));
    CHECK(reached(ui::ChangeLight{}));
    CHECK(reached(ui::ChangeTextSize{}));
    CHECK(reached(ui::ChangePlay{}));
    using ui::Action;
    CHECK(actions == std::set<Action>{Action::toggle_run, Action::one_step, Action::restart, Action::new_seed,
                                      Action::previous_scene, Action::next_scene, Action::full_screen,
                                      Action::camera_home, Action::toggle_laws, Action::toggle_meters,
                                      Action::toggle_budget, Action::toggle_explorer, Action::toggle_costs,
                                      Action::shoot_ball, Action::add_cluster, Action::toggle_hand,
                                      Action::toggle_shake});
}

TEST_CASE("an open list closes when asked to", "[ui]") {
    test::HeadlessGui gui;
    ui::State state = full_state();
    gui.frame(state);
    gui.click(state, 1100.0f, 24.0f);  // the list of scenes
    gui.frame(state);
    REQUIRE(gui.popup_open());
    state.close_popups = true;
    gui.frame(state);
    CHECK_FALSE(gui.popup_open());
}

TEST_CASE("messages and failures are dismissed by their buttons", "[ui]") {
    test::HeadlessGui gui;
    ui::State state = full_state();
    state.message = "Something was refused.";
    state.status.bits = STATUS_OUT_OF_BOUNDS;
    std::set<std::size_t> kinds;
    for (float y = 10.0f; y < 400.0f; y += 8.0f) {
        for (const ui::Command& command : gui.click(state, 40.0f, y)) {
            kinds.insert(command.index());
        }
    }
    CHECK(kinds ==
          std::set<std::size_t>{ui::Command(ui::ClearStatus{}).index(), ui::Command(ui::DismissMessage{}).index()});
}
