// The views into grid, neighbours and buffers without a window: what they take from the copies, what they say, what a
// click asks for.
#include <cmath>

#include "app/probe_legend.h"
#include "app/probe_overlay.h"
#include "app/probe_sample.h"
#include "app/window_views.h"
#include "support/catch.h"
#include "support/headless_gui.h"
#include "support/inspection.h"
#include "ui/probe_panels.h"
#include "ui/widgets.h"

using namespace ballpit;
using test::contains;
using test::inspected_session;
using test::Loop;
using test::Screen;

namespace {

struct Copies {
    std::array<Bytes, slot_count> bytes;
    app::SlotBytes slots;

    explicit Copies(Backend& backend) {
        for (std::size_t i = 0; i < slot_count; ++i) {
            bytes[i] = backend.read(static_cast<Slot>(i));
            slots.slots[i] = &bytes[i];
        }
    }
};

measure::BufferSample sample_of(app::Session& session) {
    const Copies copies(session.simulation().backend());
    auto sample = app::make_sample(copies.slots, session.stepper().schedule(), session.simulation().params(),
                                   session.stepper().position().dispatch);
    REQUIRE(sample);
    return *sample;
}

std::string follow_text(test::HeadlessGui& gui, const ui::ProbeState& probe) {
    const Screen screen(probe);
    return gui.text([&] {
        ui::Commands commands;
        ui::follow_panel(screen.state, commands);
    });
}

}  // namespace

TEST_CASE("a sample is of one substep, wherever in it the run stands", "[inspection]") {
    app::Session session = inspected_session("rain", 300);
    session.forward(StepUnit::step);
    const Moment moment = session.stepper().position().moment;
    const auto count = static_cast<std::uint32_t>(session.stepper().schedule().dispatches.size());
    const auto begin = read_slot<vec4>(session.simulation().backend(), Slot::positions);
    for (std::uint32_t ran = 1; ran < count; ++ran) {
        session.forward(StepUnit::pass);
        const measure::BufferSample sample = sample_of(session);
        const Stage next = session.stepper().schedule().dispatches[ran].stage;
        CHECK(sample.positions == begin);
        CHECK(sample.keys.size() == 512);
        CHECK(sample.cell_ranges.empty() == (next != Stage::collide));
        CHECK(sample.next_positions.empty());
    }
    session.forward(StepUnit::pass);
    REQUIRE(session.stepper().position().moment > moment);
    const measure::BufferSample whole = sample_of(session);
    CHECK(whole.positions == begin);
    CHECK(whole.next_positions == read_slot<vec4>(session.simulation().backend(), Slot::positions));
    CHECK(whole.cell_ranges.size() == whole.grid.cell_count());
    const auto probe = measure::probe_ball(whole, 7);
    REQUIRE(probe.velocity_change);
    CHECK(*probe.velocity_change == vec3(whole.next_velocities[7]) - vec3(whole.velocities[7]));

    session.back(StepUnit::substep);  // the buffers hold the substep before again, and so says the sample
    const measure::BufferSample before = sample_of(session);
    CHECK(before.next_positions == begin);
}

TEST_CASE("before the first substep a sample has what was filled ahead of it", "[inspection]") {
    app::Session session = inspected_session("rain", 300);
    Settings sorted = session.simulation().settings();
    sorted.sort = GENERATE(SortMethod::bitonic_fused, SortMethod::counting);
    session.want(sorted);
    session.apply(false);
    const measure::BufferSample bare = sample_of(session);
    CHECK(bare.keys.empty());
    CHECK(bare.cell_ranges.empty());
    CHECK(bare.next_positions.empty());
    session.prepare_cells();
    const measure::BufferSample prepared = sample_of(session);
    CHECK(prepared.cell_ranges.size() == prepared.grid.cell_count());
    CHECK(prepared.next_positions.empty());
    CHECK(measure::probe_ball(prepared, 3).slot);

    session.forward(StepUnit::step);
    Settings settings = session.simulation().settings();
    settings.cell_factor = 2.0;  // cells made anew, from the balls as they are now
    session.want(settings);
    session.apply(false);
    session.prepare_cells();
    const measure::BufferSample changed = sample_of(session);
    CHECK(changed.next_positions.empty());
    CHECK(changed.positions == read_slot<vec4>(session.simulation().backend(), Slot::positions));
    CHECK_FALSE(changed.cell_ranges.empty());
    CHECK_FALSE(app::make_sample({}, session.stepper().schedule(), session.simulation().params(), 0));
}

TEST_CASE("the trace names every buffer, and each arrow leads to its element", "[inspection]") {
    Loop loop(inspected_session("pile", 800));
    loop.session.forward(StepUnit::step);
    loop.act(ui::Action::next_ball);
    CHECK(loop.inspection.ball == 0u);
    loop.act(ui::Action::previous_ball);
    CHECK(loop.inspection.ball == 799u);
    loop.frame();
    REQUIRE(loop.state.follow != nullptr);
    const auto links = ui::trace_links(*loop.state.follow, loop.state.within_substep);
    REQUIRE(links.size() == 5);
    CHECK(links[0].text == "ball 799");
    CHECK(links[0].slot == Slot::next_positions);  // between substeps the state before lies there
    CHECK(links[1].slot == Slot::cell_ranges);
    CHECK(links[1].element == loop.state.follow->cell_id);
    CHECK(links[2].slot == Slot::keys);
    CHECK(links[2].element == loop.state.follow->slot);
    CHECK(contains(links[3].text, "neighbours "));
    CHECK(contains(links[4].text, "Δv ("));
    CHECK(links[4].slot == Slot::velocities);
    loop.views.act(ui::ShowElement{links[2].slot, links[2].element});
    loop.frame();
    CHECK(loop.state.options.buffers);
    CHECK(loop.state.options.slot == Slot::keys);
    const auto keys = typed<Key>(loop.state.buffer);
    CHECK(keys[loop.state.buffer_jump.element].ball_id == 799);

    test::HeadlessGui gui;
    const std::string text = follow_text(gui, loop.state);
    for (const char* part : {"ball 799", "cell ", "slot ", "neighbours ", "m/s", "tested", "overlap (m)"}) {
        INFO(part);
        CHECK(contains(text, part));
    }
    loop.act(ui::Action::clear_selection);
    loop.frame();
    CHECK(loop.state.follow == nullptr);
    CHECK(contains(follow_text(gui, loop.state), "Click a ball"));
}

TEST_CASE("in the middle of a substep the follow panel says what is still to come", "[inspection]") {
    Loop loop(inspected_session("pile", 200));
    loop.session.forward(StepUnit::pass);  // assign_cells
    loop.act(ui::Action::next_ball);
    loop.frame();
    REQUIRE(loop.state.follow != nullptr);
    CHECK(loop.state.within_substep);
    const auto links = ui::trace_links(*loop.state.follow, true);
    REQUIRE(links.size() == 3);
    CHECK(links[0].slot == Slot::positions);
    test::HeadlessGui gui;
    CHECK(contains(follow_text(gui, loop.state), "build_grid comes later"));
}

TEST_CASE("a click picks the ball or the cell under it, beside everything it clears", "[inspection]") {
    Loop loop(inspected_session("two_balls", 2));
    const app::WindowExtent window{1000.0f, 800.0f, 1000.0f};
    view::Camera camera;
    camera.position = vec3(0.0f, -6.0f, 0.0f);
    camera.yaw = 1.5707963f;
    const auto positions = read_slot<vec4>(loop.session.simulation().backend(), Slot::positions);
    const auto place_of = [&](const vec4& ball) {
        const vec3 half_extent(loop.session.simulation().half_extent());
        const vec4 clip = view::projection(camera, half_extent, 1000.0f / 800.0f) * view::view_matrix(camera) *
                          vec4(vec3(ball), 1.0f);
        return view::vec2(500.0f * (1.0f + clip.x / clip.w), 400.0f * (1.0f - clip.y / clip.w));
    };
    loop.views.pick(place_of(positions[1]), false, window, camera, loop.session, loop.inspection);
    CHECK(loop.inspection.ball == 1u);
    loop.frame();
    CHECK(loop.state.options.follow);
    loop.views.pick({10.0f, 10.0f}, false, window, camera, loop.session, loop.inspection);
    CHECK_FALSE(loop.inspection.ball);

    loop.session.forward(StepUnit::substep);
    loop.views.pick(place_of(positions[0]), true, window, camera, loop.session, loop.inspection);
    loop.frame();
    REQUIRE(loop.inspection.cell);
    const auto keys = read_slot<Key>(loop.session.simulation().backend(), Slot::keys);
    CHECK(keys[0].cell_id == loop.inspection.cell);
    CHECK(loop.state.cell_jump.element == loop.inspection.cell);
}

TEST_CASE("the table of cells lists, filters and leads to the balls", "[inspection]") {
    Loop loop(inspected_session("pile", 500));
    loop.act(ui::Action::toggle_cells);
    loop.frame();
    REQUIRE_FALSE(loop.state.cells.empty());
    for (const std::uint32_t cell : loop.state.cells) {
        CHECK(loop.state.sample->cell_ranges[cell].first != loop.state.sample->cell_ranges[cell].end);
    }
    ui::ProbeOptions options = loop.state.options;
    options.cell_order = {measure::CellColumn::balls, true, false};
    loop.views.act(ui::ChangeProbe{options});
    loop.frame();
    CHECK(loop.state.cells.size() == loop.state.sample->cell_ranges.size());
    loop.views.select_cell_of_ball(17, loop.inspection);
    loop.frame();
    REQUIRE(loop.state.cell);
    const auto balls = measure::balls_of_cell(*loop.state.sample, *loop.state.cell);
    CHECK(std::ranges::find(balls, 17u) != balls.end());

    test::HeadlessGui gui;
    const Screen screen(loop.state);
    const std::string text = gui.text([&] {
        ui::Commands commands;
        ui::cells_panel(screen.state, commands);
    });
    CHECK(contains(text, "holds"));
    CHECK(contains(text, "17"));
    loop.views.select_cell_of_ball(100000, loop.inspection);
    CHECK(contains(loop.views.take_message(), "no ball 100000"));
}

TEST_CASE("lines, rings and legends say the same", "[inspection]") {
    Loop loop(inspected_session("pile", 400));
    for (int i = 0; i < 40; ++i) {
        loop.session.step();
    }
    loop.act(ui::Action::toggle_contacts);
    loop.act(ui::Action::next_ball);
    loop.frame();
    view::Overlay overlay;
    loop.views.add_to(overlay, loop.inspection, loop.session);
    const measure::FoundPairs pairs = measure::found_pairs(*loop.state.sample);
    CHECK(overlay.lines.size() == pairs.found.size() + 12 * loop.state.follow->cells.size());
    CHECK(overlay.highlights.size() == loop.state.follow->tested);
    CHECK(overlay.fade_others > 0.0f);
    REQUIRE(loop.state.legends.size() == 2);
    CHECK(contains(loop.state.legends[0].entries[0].text, ui::grouped(pairs.found.size()) + " found"));
    test::HeadlessGui gui;
    CHECK(contains(gui.text([&] { ui::legend_panel(loop.state.legends[1]); }), "tested, touches it"));

    loop.act(ui::Action::toggle_slice);
    loop.act(ui::Action::slice_axis);
    loop.act(ui::Action::layer_down);
    loop.act(ui::Action::toggle_arrows);
    for (int i = 0; i < 1000; ++i) {
        loop.act(ui::Action::layer_up);
    }
    view::Overlay more;
    loop.views.add_to(more, loop.inspection, loop.session);
    REQUIRE(more.slice);
    CHECK(more.slice->axis == 0);
    CHECK(more.slice->layer == loop.session.simulation().schedule().grid.cells.x - 1);
    CHECK(more.arrow_seconds > 0.0f);
}

TEST_CASE("closed views want nothing, work out nothing and draw nothing", "[inspection]") {
    Loop loop(inspected_session("pile", 400));
    loop.inspection.ball = 3;  // selected, but not followed
    const std::uint64_t revision = loop.session.revision();
    loop.frame();
    CHECK(loop.session.revision() == revision);  // no cells were filled for nobody
    for (std::size_t i = 0; i < slot_count; ++i) {
        CHECK(loop.inspector.bytes(static_cast<Slot>(i)) == nullptr);
    }
    CHECK(loop.state.sample == nullptr);
    CHECK(loop.state.legends.empty());
    CHECK_FALSE(loop.views.working());
    view::Overlay overlay;
    loop.views.add_to(overlay, loop.inspection, loop.session);
    CHECK(overlay.empty());
}

TEST_CASE("ranges of colours stand still, numbers are short", "[inspection]") {
    CHECK(app::round_up(0.0f) == 0.0f);
    CHECK(app::round_up(0.013f) == Approx(0.015f));
    CHECK(app::round_up(0.021f) == Approx(0.03f));
    CHECK(app::round_up(8.1f) == Approx(10.0f));
    CHECK(app::round_up(std::nanf("")) == 0.0f);
    CHECK(ui::short_number(0.16345) == "0.163");
    CHECK(ui::short_number(-2.0) == "−2");
    CHECK(ui::short_number(0.0) == "0");
    CHECK(ui::short_number(std::nan("")) == "NaN");
    CHECK(ui::range_text(4402, 4418) == "4\u2009402…4\u2009417");
    CHECK(ui::range_text(5, 6) == "5");
}
