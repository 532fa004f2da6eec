// Strip, microscope and badges without a window: where marks lie, and what sentences say.
#include <set>

#include "cpu/cpu_backend.h"
#include "measure/sort_pass.h"
#include "support/catch.h"
#include "support/scenes.h"
#include "support/stepping_stage.h"
#include "ui/microscope.h"
#include "ui/stage_sentence.h"
#include "ui/stepping_panels.h"
#include "ui/strip_layout.h"

using namespace ballpit;
using test::schedule_of;

namespace {

bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("sentences give this frame's numbers", "[stepping-ui]") {
    CHECK(ui::stage_sentence({}).empty());
    CHECK(ui::stage_sentence(measure::SortNumbers{17, 91, 32, 4, 4096, 1203}) ==
          "Sort pass 17 of 91: k = 32, j = 4; 1\u2009203 of 4\u2009096 pairs swapped.");
    CHECK(ui::stage_sentence(measure::SortNumbers{1, 1, 2, 1, 1, 0}) ==
          "Sort pass 1 of 1: k = 2, j = 1; 0 of 1 pair swapped.");
    CHECK(ui::stage_sentence(measure::SortNumbers{1, 1, 2, 1, 1, std::nullopt}) == "Sort pass 1 of 1: k = 2, j = 1.");
    CHECK(ui::stage_sentence(measure::AssignNumbers{5000, 13671, 4394, 3192, 2}) ==
          "Cells assigned: 5\u2009000 balls lie in 4\u2009394 of 13\u2009671 cells; 2 outside the box; "
          "3\u2009192 keys pad to a power of two.");
    CHECK(contains(ui::stage_sentence(measure::AssignNumbers{1, 8, 1, 0, 0}),
                   "1 ball lies in 1 of 8 cells, none outside"));
    CHECK(ui::stage_sentence(measure::ClearNumbers{8}) == "Cell table emptied: 8 cells hold no slots now.");
    CHECK(ui::stage_sentence(measure::BuildNumbers{3, 8, 5, 2}) ==
          "Grid built: 3 of 8 cells occupied; the fullest, cell 5, holds 2 balls.");
    CHECK(ui::stage_sentence(measure::CollideNumbers{12, 0.0032f, 73, 4.125f, 0}) ==
          "Balls moved: 12 contacts, largest overlap 3.2 mm; fastest: ball 73 at 4.12 m/s.");
    CHECK(contains(ui::stage_sentence(measure::CollideNumbers{std::nullopt, 0.0f, 0, 1.0f, 3}),
                   "3 without a number for a speed"));
    CHECK(ui::length_text(2.0) == "2 m");
    CHECK(ui::length_text(12e-6) == "12 µm");
}

TEST_CASE("the numbers are those of the buffers", "[stepping-ui]") {
    const Scene scene = test::shipped_scene("rain");
    Settings settings = scene.settings;
    settings.balls = 300;
    Simulation simulation(scene, settings, 1, std::make_unique<cpu::CpuBackend<float>>());
    const Schedule schedule =
        make_schedule(300, simulation.schedule().grid, simulation.features(), SortMethod::bitonic);
    Backend& backend = simulation.backend();
    backend.run(schedule, simulation.params(), 0, 1);
    auto keys = read_slot<Key>(backend, Slot::keys);
    const auto positions = read_slot<vec4>(backend, Slot::positions);
    const auto assigned = measure::assign_numbers(schedule, keys, positions, simulation.box());
    CHECK(assigned.balls == 300);
    CHECK(assigned.padding == 512 - 300);
    CHECK(assigned.outside == 0);
    CHECK(measure::assign_numbers(schedule, keys, positions, Box(dvec3(0.0))).outside == 300);
    for (std::size_t i = 1; schedule.dispatches[i].stage == Stage::bitonic_sort; ++i) {
        const auto before = read_slot<Key>(backend, Slot::keys);
        backend.run(schedule, simulation.params(), i, i + 1);
        const auto after = read_slot<Key>(backend, Slot::keys);
        const auto numbers = measure::sort_numbers(schedule, schedule.dispatches[i], before);
        CHECK(numbers.pass == i);
        CHECK(numbers.passes == 45);
        CHECK(numbers.pairs == 256);
        std::uint32_t moved = 0;
        for (std::size_t slot = 0; slot < before.size(); ++slot) {
            moved += before[slot] == after[slot] ? 0 : 1;
        }
        CHECK(numbers.swapped == moved / 2);
    }
    backend.run(schedule, simulation.params(), 46, 48);
    const auto built = measure::build_numbers(read_slot<CellRange>(backend, Slot::cell_ranges));
    CHECK(built.occupied == assigned.occupied);
    CHECK(built.cells == schedule.cell_count);
    CHECK(built.most >= 1);
    backend.run(schedule, simulation.params(), 48, 49);
    const auto moved = measure::collide_numbers(positions, read_slot<vec4>(backend, Slot::next_velocities));
    CHECK(moved.contacts.has_value());
    CHECK(moved.fastest.has_value());
    CHECK(moved.top_speed > 0.0f);
    CHECK(moved.not_finite == 0);
}

TEST_CASE("chips follow the schedule, and every dispatch has a mark that is found again", "[stepping-ui]") {
    for (const std::uint32_t balls : {1u, 2u, 200u, 5000u, 100000u}) {
        const Schedule schedule = schedule_of(balls);
        const auto chips = ui::stage_chips(schedule, 880.0f, 10.0f);
        REQUIRE(chips.size() == (balls == 1 ? 3u : 4u));  // one key needs no sort
        CHECK(chips.front().left == 0.0f);
        CHECK(chips.back().right == Approx(880.0f));
        std::uint32_t next = 0;
        for (const ui::StripChip& chip : chips) {
            CHECK(chip.first == next);
            next = chip.last;
            CHECK(chip.right - chip.left >= 100.0f);  // room for its name
            for (std::uint32_t dispatch = chip.first; dispatch < chip.last; ++dispatch) {
                const ui::StripMark mark = ui::mark_of(chip, dispatch);
                CHECK(ui::dispatch_at(chip, 0.5f * (mark.left + mark.right)) == dispatch);
            }
            CHECK_FALSE(ui::dispatch_at(chip, chip.left - 1.0f));
            CHECK_FALSE(ui::dispatch_at(chip, chip.right + 1.0f));
        }
        CHECK(next == schedule.dispatches.size());
    }
    CHECK(ui::stage_chips(schedule_of(0), 880.0f, 10.0f).empty());
}

TEST_CASE("with many substeps the strip shows those around the present one", "[stepping-ui]") {
    CHECK(ui::substep_blocks(8, 3, 880.0f, 14.0f).size() == 8);
    for (const std::uint32_t shown : {0u, 5u, 511u, 1023u}) {
        const auto blocks = ui::substep_blocks(1024, shown, 880.0f, 14.0f);
        CHECK(blocks.size() == 62);
        CHECK(blocks.front().substep <= shown);
        CHECK(blocks.back().substep >= shown);
        CHECK(blocks.back().substep < 1024);
        CHECK(blocks.back().right == Approx(880.0f));
    }
}

TEST_CASE("a window of the microscope holds both partners of every pair", "[stepping-ui]") {
    for (const std::uint32_t keys : {1u, 16u, 64u, 8192u}) {
        for (const std::uint32_t wanted : {16u, 64u}) {
            for (std::uint32_t j = 1; j < keys; j *= 2) {
                for (const std::uint32_t first : {0u, 17u, 4100u, 8191u}) {
                    const ui::SlotWindow window = ui::slot_window(keys, wanted, first, j);
                    CHECK(window.slots.size() == std::min(keys, wanted));
                    const std::set<std::uint32_t> shown(window.slots.begin(), window.slots.end());
                    CHECK(shown.size() == window.slots.size());
                    CHECK(*shown.rbegin() < keys);
                    for (const std::uint32_t slot : window.slots) {
                        CHECK(shown.count(slot ^ j) == 1);
                    }
                    CHECK((window.split > 0) == (keys > wanted && j >= wanted));
                }
            }
        }
    }
}

TEST_CASE("a slot's story says thread, partner, direction and why, and whether it was swapped", "[stepping-ui]") {
    const std::vector<Key> before = {{5, 0}, {3, 1}, {1, 2}, {2, 3}};
    const std::vector<Key> after = {{3, 1}, {5, 0}, {2, 3}, {1, 2}};
    const ui::ShownPass pass{2, 1};
    const std::string first = ui::slot_story(1, pass, after, before);
    CHECK(contains(first, "Slot 1: cell 5, ball 0"));
    CHECK(contains(first, "Thread 0 compares it with slot 1 XOR 1 = 0."));
    CHECK(contains(first, "Ascending: bit k = 2 of slot 0 is 0, so the larger key belongs to slot 1."));
    CHECK(contains(first, "Swapped: before, it held cell 3, ball 1."));
    const std::string second = ui::slot_story(2, pass, after, before);
    CHECK(contains(second, "Thread 1"));
    CHECK(contains(second, "Descending: bit k = 2 of slot 2 is 1, so the larger key belongs to slot 2."));
    CHECK(ui::slot_story(0, std::nullopt, after, before) == "Slot 0: cell 3, ball 1");
    CHECK(contains(ui::slot_story(0, pass, std::vector<Key>(4, {SENTINEL, SENTINEL}), before), "padding"));
}

TEST_CASE("badges: green, amber, red, and what follows a red one is not judged", "[stepping-ui]") {
    using Kind = ui::Badge::Kind;
    ui::LiveCheckState check;
    const auto kind = [&](Stage stage) { return ui::stage_badge(check, stage).kind; };
    CHECK(kind(Stage::collide) == Kind::none);
    check.mode = ui::LiveCheckMode::mirror;
    CHECK(kind(Stage::collide) == Kind::none);  // has not run
    for (ui::StageCheck& stage : check.stages) {
        stage = {true, true, 8192, 0, 0, 0, 0.0, "", {}, {}};
    }
    CHECK(ui::stage_badge(check, Stage::bitonic_sort).text == "0 of 8\u2009192 differ");
    ui::StageCheck& collide = check.stages[static_cast<std::size_t>(Stage::collide)];
    collide.differing = 12;
    collide.max_ulp = 2;
    collide.of_bound = 0.25;
    collide.first = "collide, ball 3: GPU 1, CPU 2";
    const ui::Badge amber = ui::stage_badge(check, Stage::collide);
    CHECK(amber.kind == Kind::within);
    CHECK(amber.text == "max 2 ULP");
    CHECK(contains(amber.detail, "25 %"));
    ui::StageCheck& assign = check.stages[0];
    assign.differing = assign.beyond_bound = 3117;
    assign.first = "assign_cells, slot 12: GPU 0, CPU 61204";
    const ui::Badge red = ui::stage_badge(check, Stage::assign_cells);
    CHECK(red.kind == Kind::differs);
    CHECK(red.text == "3\u2009117 differ");
    CHECK(red.detail == "3\u2009117 differ, first: assign_cells, slot 12: GPU 0, CPU 61204.");
    collide.beyond_bound = 1;
    CHECK(kind(Stage::collide) == Kind::not_judged);
    check.stages[1].violation = "slot 3 holds nothing";
    CHECK(kind(Stage::bitonic_sort) == Kind::not_judged);
    assign.beyond_bound = assign.differing = 0;
    CHECK(kind(Stage::bitonic_sort) == Kind::differs);
    CHECK(contains(ui::stage_badge(check, Stage::bitonic_sort).detail, "sorted, a permutation"));
    check.mode = ui::LiveCheckMode::off;
    CHECK(kind(Stage::assign_cells) == Kind::none);
}
