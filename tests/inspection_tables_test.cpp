// The tables of all buffers without a window: units, pages, wishes for an element, export.
#include <filesystem>
#include <fstream>
#include <thread>

#include "support/catch.h"
#include "support/headless_gui.h"
#include "support/inspection.h"
#include "support/temporary_folder.h"
#include "ui/paging.h"
#include "ui/probe_panels.h"
#include "ui/widgets.h"

using namespace ballpit;
using test::contains;
using test::inspected_session;
using test::Loop;
using test::Screen;

TEST_CASE("every buffer is a table with units, paged where it is long", "[inspection]") {
    Loop loop(inspected_session("pile", 300));
    loop.session.forward(StepUnit::step);
    loop.act(ui::Action::toggle_buffers);
    test::HeadlessGui gui;
    const auto text = [&] {
        loop.frame();
        const Screen screen(loop.state);
        return gui.text([&] {
            ImGui::SetWindowSize(ImVec2(800.0f, 600.0f));
            ui::Commands commands;
            ui::buffers_panel(screen.state, commands);
        });
    };
    CHECK(contains(text(), "radius (m)"));
    for (std::size_t i = 1; i < slot_count; ++i) {
        loop.act(ui::Action::next_slot);
        const auto slot = static_cast<Slot>(i);
        INFO(slot_name(slot));
        const std::string words = text();
        CHECK(contains(words, slot_name(slot)));
        const std::array absent = {Slot::damping_ratios, Slot::compensations, Slot::built_positions, Slot::tickets,
                                   Slot::scattered_keys, Slot::tile_counts,   Slot::origins};
        if (std::ranges::count(absent, slot) > 0) {
            CHECK(contains(words, "Empty"));
        } else {
            CHECK(contains(words, "as it is now"));
        }
    }
    CHECK(ui::page_count(0) == 0);
    CHECK(ui::page_count(10000) == 1);
    CHECK(ui::page_count(10001) == 2);
    CHECK(ui::page_of(9999) == 0);
    CHECK(ui::page_of(10000) == 1);
}

TEST_CASE("a wish for an element turns the page once", "[inspection]") {
    test::HeadlessGui gui;
    std::uint64_t first = 0;
    const auto draw = [&](const ui::Jump& jump) {
        gui.text([&] {
            ui::Pager pager("table", 35000);
            pager.follow(jump, jump.element);
            first = pager.first_row();
            CHECK(pager.rows_here() == (first == 30000 ? 5000 : 10000));
            pager.draw();
        });
    };
    draw({});
    CHECK(first == 0);
    draw({31234, 1});
    CHECK(first == 30000);
    draw({12, 1});  // the wish of that serial has been granted
    CHECK(first == 30000);
    draw({12, 2});
    CHECK(first == 0);
    draw({99999, 3});  // there is no such row
    CHECK(first == 0);
}

TEST_CASE("a slot is exported whole, and a place that cannot be written is told", "[inspection]") {
    const test::TemporaryFolder folder;
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(folder.path());
    Loop loop(inspected_session("pile", 100));
    loop.session.forward(StepUnit::step);
    loop.act(ui::Action::toggle_buffers);
    loop.frame();
    const auto message = [&loop] {
        loop.views.export_slot(Slot::positions, loop.inspector, loop.session);
        while (loop.views.working()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            loop.frame();
        }
        return loop.views.take_message();
    };
    CHECK(contains(message(), "ballpit_step1_positions.csv"));
    std::ifstream file("ballpit_step1_positions.csv");
    std::string line;
    std::getline(file, line);
    CHECK(line == "ball,x,y,z,radius");
    int rows = 0;
    while (std::getline(file, line)) {
        ++rows;
    }
    CHECK(rows == 100);
    const auto gone = folder.path() / "gone";
    std::filesystem::create_directory(gone);
    std::filesystem::current_path(gone);
    std::filesystem::remove(gone);
    CHECK_FALSE(contains(message(), "Written"));
    std::filesystem::current_path(before);
}
