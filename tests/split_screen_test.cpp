// The grid beside brute force: both sides stay together, and what the grid misses is counted.

#include "app/window_split.h"
#include "app/window_views.h"
#include "support/catch.h"
#include "support/headless_gui.h"
#include "support/inspection.h"
#include "ui/probe_panels.h"

using namespace ballpit;
using test::inspected_session;
using test::Loop;

namespace {

bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("both sides of the split screen take the same steps, forth and back", "[inspection]") {
    app::Session session = inspected_session("pile", 300);
    session.forward(StepUnit::step);
    app::Split split;
    CHECK_FALSE(split.follow(session));
    REQUIRE(split.open());
    const auto right = [&] { return read_slot<vec4>(split.simulation().backend(), Slot::positions); };
    const auto left = [&] { return read_slot<vec4>(session.simulation().backend(), Slot::positions); };
    CHECK(right() == left());
    CHECK(split.simulation().settings().neighbours == NeighbourSearch::brute_force);
    CHECK(split.simulation().schedule().cell_count == 0);

    std::vector<std::vector<vec4>> states{right()};
    for (int i = 0; i < 5; ++i) {
        session.forward(StepUnit::substep);
        CHECK_FALSE(split.follow(session));
        CHECK(split.simulation().step_count() == session.simulation().step_count());
        CHECK(split.simulation().substep_in_step() == session.simulation().substep_in_step());
        states.push_back(right());
    }
    for (int i = 4; i >= 0; --i) {
        session.back(StepUnit::substep);
        CHECK_FALSE(split.follow(session));
        CHECK(right() == states[static_cast<std::size_t>(i)]);
    }
    session.back(StepUnit::step);  // to before the split screen was opened: anew from the left side's bytes
    CHECK_FALSE(split.follow(session));
    CHECK(right() == left());

    session.forward(StepUnit::step);
    CHECK_FALSE(split.follow(session));
    Settings settings = session.simulation().settings();
    settings.gravity.z = -1.6;
    session.want(settings);
    session.apply(false);
    CHECK_FALSE(split.follow(session));
    CHECK(split.simulation().settings().gravity.z == -1.6);
    CHECK(right() == left());
}

TEST_CASE("the split screen counts what the grid tests, finds and misses", "[inspection]") {
    Loop loop(inspected_session("pile", 600));
    for (int i = 0; i < 30; ++i) {
        loop.session.step();
    }
    loop.act(ui::Action::toggle_split);
    loop.frame();
    loop.session.forward(StepUnit::substep);
    loop.frame();
    CHECK(loop.state.grid_side.known);
    CHECK(loop.state.brute_side.known);
    CHECK(loop.state.grid_side.missed == 0);
    CHECK(loop.state.grid_side.contacts > 20);
    CHECK(loop.state.grid_side.contacts == loop.state.brute_side.contacts);
    CHECK(loop.state.brute_side.tested == std::uint64_t{600} * 599);
    CHECK(loop.state.grid_side.tested < loop.state.brute_side.tested / 2);
    REQUIRE(loop.state.apart);
    CHECK(*loop.state.apart < 1e-5);

    Settings settings = loop.session.simulation().settings();
    settings.cell_factor = 0.5;
    loop.session.want(settings);
    loop.session.apply(false);
    loop.frame();
    loop.session.forward(StepUnit::substep);
    loop.frame();
    CHECK(loop.state.grid_side.missed > 0);
    CHECK(loop.state.grid_side.contacts + loop.state.grid_side.missed == loop.state.brute_side.contacts);
    view::Overlay overlay;
    loop.views.add_to(overlay, loop.inspection, loop.session);
    CHECK(overlay.lines.size() == loop.state.grid_side.missed);

    for (int i = 0; i < 3; ++i) {
        loop.frame(true);  // running: copies come late, and nothing waits
    }
    CHECK(loop.state.brute_side.known);
    CHECK_FALSE(loop.state.apart);
    test::HeadlessGui gui;
    const std::string text = gui.text([&] { ui::split_counts(loop.state.grid_side); });
    for (const char* part : {"Grid", "pairs tested", "contacts missed"}) {
        CHECK(contains(text, part));
    }
    loop.act(ui::Action::toggle_split);
    loop.frame();
    CHECK_FALSE(loop.views.split());
}

TEST_CASE("brute force is refused in a sentence where it would hang the machine or find nothing", "[inspection]") {
    CHECK_FALSE(app::brute_force_refusal(5000, true, "cpu"));
    CHECK(contains(*app::brute_force_refusal(5001, true, "cpu"), "5\u2009000 balls"));
    CHECK_FALSE(app::brute_force_refusal(20000, true, "gpu"));
    CHECK(contains(*app::brute_force_refusal(20001, true, "gpu"), "20\u2009000 balls"));
    CHECK(contains(*app::brute_force_refusal(5, false, "gpu"), "no contacts"));

    Loop loop(inspected_session("rain", 6000));
    loop.act(ui::Action::toggle_split);
    loop.frame();
    CHECK_FALSE(loop.views.split());
    CHECK_FALSE(loop.state.options.split);
    CHECK(contains(loop.views.take_message(), "Brute force would test"));
}
