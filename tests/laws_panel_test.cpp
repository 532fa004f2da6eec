// The laws of a scene on screen: which are ticked, why, what they cost, and what a click asks for.
#include <set>
#include <variant>

#include "support/catch.h"
#include "support/headless_gui.h"
#include "ui/laws_panel.h"

using namespace ballpit;

namespace {

bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

const std::array<ui::SceneChoice, 1> scenes = {{{"Rain", "Balls fall."}}};

struct Shown {
    ui::LawsState laws;
    ui::State state;

    Shown() {
        state.scenes = scenes;
        state.settings.laws = state.defaults.laws = parse_laws("gravity,contact,walls,diagnostics");
        state.variety.radius = 0.1f;
        state.variety.mass = 4.19f;
        state.backend_name = "gpu";
        state.laws = &laws;
        laws.ball_count = 5000;
        laws.bytes_a_ball = 98.5;
        laws.dispatches = 12;
    }
};

std::string panel_text(test::HeadlessGui& gui, const ui::State& state) {
    return gui.text([&state] {
        ImGui::Dummy(ImVec2(900.0f, 1.0f));
        ui::Commands commands;
        ui::laws_panel(state, commands);
    });
}

std::set<std::string> laws_clicked(test::HeadlessGui& gui, const Shown& shown, bool& measured, bool& closed) {
    std::set<std::string> turned;
    for (float y = 100.0f; y < 715.0f; y += 7.0f) {
        for (const ui::Command& command : gui.click(shown.state, 30.0f, y)) {
            if (const auto* change = std::get_if<ui::ChangeSettings>(&command)) {
                for (const LawInfo& law : law_table()) {
                    if (change->settings.laws.*law.member != shown.state.settings.laws.*law.member) {
                        turned.insert(std::string(law.key));
                    }
                }
            }
            measured |= std::holds_alternative<ui::MeasureLaws>(command);
        }
    }
    const ImGuiWindow* window = ImGui::FindWindowByName("Laws of this scene");
    REQUIRE(window != nullptr);
    const float x = window->Pos.x + window->Size.x - 0.8f * ui::em();  // the cross
    for (const ui::Command& command : gui.click(shown.state, x, window->Pos.y + 0.7f * ui::em())) {
        const auto* action = std::get_if<ui::Action>(&command);
        closed |= action != nullptr && *action == ui::Action::toggle_laws;
    }
    return turned;
}

}  // namespace

TEST_CASE("each law says what it changes, what it asks for and why it is off", "[ui]") {
    test::HeadlessGui gui;
    Shown shown;
    const std::string text = panel_text(gui, shown.state);
    for (const LawInfo& law : law_table()) {
        INFO(law.key);
        CHECK(contains(text, law.label));
    }
    CHECK(contains(text, "98.5 B a ball"));
    CHECK(contains(text, "12 dispatches a substep"));
    CHECK(contains(text, "All balls have radius 0.1 m."));
    CHECK(contains(text, "All balls have mass 4.19 kg."));
    CHECK(contains(text, "The scene does not declare it."));
}

TEST_CASE("why a law is on or off", "[ui]") {
    const auto why = [](const char* key, const char* now, const char* declared, const Variety& variety = {},
                        bool own = false) {
        const LawInfo& law = *std::ranges::find(law_table(), std::string_view(key), &LawInfo::key);
        return ui::standing_of(law, parse_laws(now), parse_laws(declared), variety, own);
    };
    CHECK(why("drag", "none", "none").why == "The scene does not declare it.");
    CHECK(why("drag", "none", "drag").why == "The scene declares it; it is ticked off.");
    CHECK(why("drag", "drag", "drag").why.empty());
    CHECK(why("drag", "drag", "none").why == "The scene does not declare it; it is ticked on.");
    CHECK(contains(why("shake", "shake", "shake").why, "Does nothing without walls."));
    CHECK(why("shake", "walls,shake", "walls,shake").why.empty());
    CHECK(contains(why("restitution", "restitution", "restitution").why, "without contact or walls"));
    Variety mixed;
    mixed.radii = mixed.masses = true;
    for (const char* key : {"unequal_radii", "unequal_masses"}) {
        const ui::LawStanding standing = why(key, "contact", "contact", mixed);
        CHECK(standing.holds);
        CHECK(standing.locked);
        CHECK_FALSE(why(key, "contact", "contact").locked);
        CHECK_FALSE(why(key, "contact", "contact").holds);
        CHECK(contains(why(key, std::string("contact," + std::string(key)).c_str(), "contact").why,
                       "Ticked all the same"));
    }
    CHECK(why("ball_restitution", "contact", "contact", {}, true).locked);
}

TEST_CASE("a click turns one law over; where balls differ it turns nothing", "[ui]") {
    test::HeadlessGui gui;
    Shown shown;
    bool measured = false;
    bool closed = false;
    CHECK(laws_clicked(gui, shown, measured, closed).size() == law_count);
    CHECK(measured);
    CHECK(closed);
    shown.state.variety.radii = shown.state.variety.masses = shown.state.own_restitutions = true;
    const auto turned = laws_clicked(gui, shown, measured, closed);
    CHECK(turned.size() == law_count - 3);
    CHECK(turned.count("unequal_radii") + turned.count("unequal_masses") + turned.count("ball_restitution") == 0);
}

TEST_CASE("the window is there only while it is open, at any size", "[ui]") {
    test::HeadlessGui gui;
    Shown shown;
    for (const ImVec2 size : {ImVec2(1280.0f, 720.0f), ImVec2(640.0f, 480.0f), ImVec2(320.0f, 200.0f)}) {
        ImGui::GetIO().DisplaySize = size;
        CHECK(gui.frame(shown.state).empty());
        CHECK(gui.shows("Laws of this scene"));
    }
    shown.state.laws = nullptr;
    gui.frame(shown.state);
    CHECK_FALSE(gui.shows("Laws of this scene"));
}

TEST_CASE("a cost is told with its uncertainty, and noise as noise", "[ui]") {
    ui::LawCost cost;
    cost.pairs = {0.03, 0.01, 0.75, 0.72, true};
    CHECK(ui::cost_text(cost, true, 0.75) == "+0.030 ms ± 0.01 ms, 4 %");
    CHECK(ui::cost_text(cost, false, 0.75) == "would be +0.030 ms ± 0.01 ms, +4 %");
    cost.pairs.known = false;
    CHECK(contains(ui::cost_text(cost, true, 0.75), "less than can be told"));
    cost.same_programs = true;
    CHECK(contains(ui::cost_text(cost, true, 0.75), "nothing"));
}

TEST_CASE("programs say what they are compiled for", "[ui]") {
    Features features;
    CHECK(ui::program_text({Shader::bitonic_sort, features}) == "bitonic_sort");
    features.add(Feature::gravity);
    features.add(Feature::unequal_radii);
    features.add(Feature::velocity_verlet);
    CHECK(ui::program_text({Shader::collide, features}) == "collide for gravity, velocity verlet, unequal radii");
}
