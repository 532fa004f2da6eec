// A student's typical mistake in each stage's shader: exactly that stage's badge turns red, and names the first slot
// that is wrong.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "app/window_live_check.h"
#include "app/window_session.h"
#include "measure/slot_table.h"
#include "support/catch.h"
#include "support/gl_fixture.h"
#include "support/gpu_backend.h"

using namespace ballpit;
using test::GlFixture;

namespace {

struct Edit {
    std::string file;
    std::string right;
    std::string wrong;
};

struct PlantedBug {
    std::string what;
    Stage stage;
    std::vector<Edit> edits;
    SortMethod sort = SortMethod::bitonic;
    bool spreads = false;  // keys that are lost or twice there: what comes later cannot be right, either
};

const std::vector<PlantedBug>& planted_bugs() {
    static const std::vector<PlantedBug> bugs = {
        {"the grid's origin is added",
         Stage::assign_cells,
         {{"shared/cells.glsl", "(point - params.grid_origin)", "(point + params.grid_origin)"}}},
        {"the cell is not rounded down but up",
         Stage::assign_cells,
         {{"assign_cells.comp", "cell_coordinates(centre)",
           "cell_coordinates(centre + 1.0 / params.inverse_cell_width)"}}},
        {"the direction comes from the wrong bit",
         Stage::bitonic_sort,
         {{"bitonic_sort.comp", "(lower & k) == 0u", "(lower & j) == 0u"}}},
        {"the direction comes from the wrong bit, fused",
         Stage::bitonic_sort,
         {{"shared/exchange.glsl", "(lower_slot & k) == 0u", "(lower_slot & (k >> 1)) == 0u"}},
         SortMethod::bitonic_fused},
        {"a cell ends one slot early", Stage::build_grid, {{"build_grid.comp", ".end = slot + 1u", ".end = slot"}}},
        {"cells are not cleared", Stage::build_grid, {{"clear_cells.comp", "CellRange(0u, 0u)", "CellRange(0u, 1u)"}}},
        {"the mass is forgotten", Stage::collide, {{"collide.comp", "force / ball.mass", "force"}}},
        {"the step's length is forgotten",
         Stage::collide,
         {{"collide.comp", "vec3 way = params.drift * v;", "vec3 way = v;"}}},
        {"reads the state that is being written",
         Stage::collide,
         {{"collide.comp", "writeonly buffer NextPositionsBlock", "buffer NextPositionsBlock"},
          {"shared/pair.glsl", "vec4 position = positions[place];", "vec4 position = next_positions[place];"}}},
        {"a range begins without the tiles before its own",
         Stage::build_grid,
         {{"scan_cells.comp", "uint first = before + sum_before(own);", "uint first = sum_before(own);"}},
         SortMethod::counting,
         true},
        {"a tile is written to and not marked",
         Stage::build_grid,
         {{"shared/used_tiles.glsl", "used_tiles[cell / TILE_CELLS] = 1u;", "used_tiles[cell / TILE_CELLS] = 0u;"}},
         SortMethod::counting,
         true},
        {"a ticket is one too high",
         Stage::counting_sort,
         {{"scatter_keys.comp", ".first + tickets[place];", ".first + tickets[place] + 1u;"}},
         SortMethod::counting,
         true},
        {"a ball comes behind itself",
         Stage::counting_sort,
         {{"order_keys.comp", ".ball_id < key.ball_id", ".ball_id <= key.ball_id"}},
         SortMethod::counting,
         true},
        {"the balls of a cell in descending order",
         Stage::counting_sort,
         {{"order_keys.comp", ".ball_id < key.ball_id", ".ball_id > key.ball_id"}},
         SortMethod::counting},
        {"the copy of another ball",
         Stage::collide,
         {{"gather.comp", "copy_state(ball, slot);", "copy_state(slot, slot);"}},
         SortMethod::counting},
        {"out of reach is taken for within",
         Stage::collide,
         {{"shared/pair.glsl", "ordered_dot(offset, offset) < reach_squared",
           "ordered_dot(offset, offset) > reach_squared"}},
         SortMethod::counting},
    };
    return bugs;
}

std::string text_of(const std::filesystem::path& file) {
    std::stringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

// A copy of the shaders with the edits, gone at the end.
class EditedShaders {
public:
    explicit EditedShaders(const std::vector<Edit>& edits)
        : folder_(std::filesystem::temp_directory_path() / ("ballpit_planted_" + std::to_string(::time(nullptr)))) {
        std::filesystem::remove_all(folder_);
        std::filesystem::copy(test::shader_folder(), folder_, std::filesystem::copy_options::recursive);
        for (const Edit& edit : edits) {
            std::string text = text_of(folder_ / edit.file);
            const std::size_t place = text.find(edit.right);
            INFO(edit.file << " has no \"" << edit.right << "\"");
            REQUIRE(place != std::string::npos);
            text.replace(place, edit.right.size(), edit.wrong);
            std::ofstream(folder_ / edit.file) << text;
        }
    }
    ~EditedShaders() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    EditedShaders(const EditedShaders&) = delete;
    EditedShaders& operator=(const EditedShaders&) = delete;
    const std::filesystem::path& folder() const { return folder_; }

private:
    std::filesystem::path folder_;
};

// Balls that lie in one another, so that every part of collide counts.
app::WindowOptions options_for(const std::filesystem::path& shaders, SortMethod sort, const std::string& backend) {
    app::WindowOptions options;
    options.scene = test::shipped_scene("pile");
    // Over more than one tile of the cell table, where that matters.
    const double top = sort == SortMethod::counting ? 2.0 : -2.0;
    options.scene.fill->region = {dvec3(-2.5, -2.5, -3), dvec3(-1.5, -1.5, top)};
    options.settings = options.scene.settings;
    options.settings.balls = 200;
    options.settings.substeps = 2;
    options.settings.sort = sort;
    options.seed = 2;
    options.backend = backend;
    options.shader_folder = shaders;
    return options;
}

ui::LiveCheckState state_of(app::LiveCheck& check) {
    ui::LiveCheckState state;
    check.describe(state);
    return state;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// `spreads`: whether stages after it may be red as well.
void check_only_red(const ui::LiveCheckState& state, Stage red, bool spreads = false) {
    for (std::size_t i = 0; i < stage_count; ++i) {
        const auto stage = static_cast<Stage>(i);
        const ui::Badge badge = ui::stage_badge(state, stage);
        CAPTURE(stage_name(stage), badge.text, badge.detail);
        if (stage == red || !spreads) {
            CHECK((badge.kind == ui::Badge::Kind::differs) == (stage == red));
        }
    }
}

// The first element whose bytes differ, found without the checker, is the one that the badge names.
void check_first_named(const ui::StageCheck& check) {
    // Where several dispatches have written, the badge tells of the buffer that differs most.
    const auto named = std::ranges::find_if(check.differences, [&check](const ui::SlotDifference& each) {
        return check.first.starts_with(std::string(each.dispatch) + ", " +
                                       std::string(measure::slot_element(each.slot)));
    });
    CAPTURE(check.first);
    REQUIRE(named != check.differences.end());
    const ui::SlotDifference& difference = *named;
    const std::size_t size = measure::slot_columns(difference.slot).size() * 4;
    std::size_t first = 0;
    while (std::equal(difference.gpu.begin() + static_cast<std::ptrdiff_t>(first * size),
                      difference.gpu.begin() + static_cast<std::ptrdiff_t>((first + 1) * size),
                      difference.cpu.begin() + static_cast<std::ptrdiff_t>(first * size))) {
        ++first;
    }
    CHECK(difference.differing.front() == first);
    const std::string name = std::string(measure::slot_element(difference.slot)) + " " + std::to_string(first) + ":";
    CHECK(contains(check.first, name));
    CHECK(contains(check.first, "GPU "));
    CHECK(contains(check.first, "CPU "));
}

// One stage after the other, until the check has seen the one that is wrong.
void step_into(app::Session& session, Stage stage) {
    session.forward(StepUnit::step);
    for (std::size_t i = 0; i <= static_cast<std::size_t>(stage); ++i) {
        if (static_cast<Stage>(i) != Stage::counting_sort) {  // not with a bitonic sort
            session.forward(StepUnit::stage);
        }
    }
}

}  // namespace

TEST_CASE_METHOD(GlFixture, "without a planted bug no badge is red, in any unit", "[planted]") {
    app::Session session(options_for(test::shader_folder(), SortMethod::bitonic_fused, "gpu"), true, "4.3");
    app::LiveCheck check(session);
    check.set_mode(ui::LiveCheckMode::mirror);
    for (const StepUnit unit : {StepUnit::step, StepUnit::substep, StepUnit::stage, StepUnit::pass}) {
        session.forward(unit);
        const ui::LiveCheckState state = state_of(check);
        CHECK(state.ms > 0.0);
        const ui::Badge first = ui::stage_badge(state, Stage::assign_cells);
        CHECK(first.text == "0 of 256 differ");
        for (std::size_t i = 0; i < stage_count; ++i) {
            const ui::Badge badge = ui::stage_badge(state, static_cast<Stage>(i));
            CAPTURE(badge.text, badge.detail);
            CHECK(badge.kind != ui::Badge::Kind::differs);
            CHECK(badge.kind != ui::Badge::Kind::not_judged);
        }
    }
}

TEST_CASE_METHOD(GlFixture, "a planted bug turns exactly its stage's badge red and names the first wrong place",
                 "[planted]") {
    for (const PlantedBug& bug : planted_bugs()) {
        CAPTURE(bug.what);
        const EditedShaders shaders(bug.edits);
        app::Session session(options_for(shaders.folder(), bug.sort, "gpu"), true, "4.3");
        app::LiveCheck check(session);
        check.set_mode(ui::LiveCheckMode::mirror);
        session.forward(StepUnit::step);
        check_only_red(state_of(check), bug.stage, bug.spreads);
        if (bug.sort == SortMethod::bitonic) {  // in parts the fused sort is stepped pass by pass
            step_into(session, bug.stage);
            check_only_red(state_of(check), bug.stage);
        }
        const ui::LiveCheckState state = state_of(check);
        if (bug.stage != Stage::bitonic_sort) {  // many passes: the first is named, the last is kept
            check_first_named(state.stages[static_cast<std::size_t>(bug.stage)]);
        }
    }
}

TEST_CASE_METHOD(GlFixture, "a sort that goes wrong is caught in the first pass that does", "[planted]") {
    const PlantedBug& bug = planted_bugs()[2];
    const EditedShaders shaders(bug.edits);
    app::Session session(options_for(shaders.folder(), bug.sort, "gpu"), true, "4.3");
    app::LiveCheck check(session);
    check.set_mode(ui::LiveCheckMode::mirror);
    session.forward(StepUnit::pass);  // assign_cells
    ui::LiveCheckState state;
    do {
        session.forward(StepUnit::pass);
        state = state_of(check);
    } while (ui::stage_badge(state, Stage::bitonic_sort).kind != ui::Badge::Kind::differs && session.place().ran < 30);
    const ui::StageCheck& sort = state.stages[static_cast<std::size_t>(Stage::bitonic_sort)];
    REQUIRE(sort.beyond_bound > 0);
    CHECK(contains(sort.first, "bitonic_sort k="));
    check_first_named(sort);
}

TEST_CASE_METHOD(GlFixture, "invariants alone catch what breaks a promise, without a mirror", "[planted]") {
    for (const std::size_t which : {std::size_t{2}, std::size_t{4}}) {
        const PlantedBug& bug = planted_bugs()[which];
        CAPTURE(bug.what);
        const EditedShaders shaders(bug.edits);
        app::Session session(options_for(shaders.folder(), bug.sort, "gpu"), true, "4.3");
        app::LiveCheck check(session);
        check.set_mode(ui::LiveCheckMode::invariants);
        session.forward(StepUnit::step);
        const ui::LiveCheckState state = state_of(check);
        check_only_red(state, bug.stage);
        const std::string detail = ui::stage_badge(state, bug.stage).detail;
        CHECK((contains(detail, "slot ") || contains(detail, "cell ")));
    }
}

TEST_CASE_METHOD(GlFixture, "on the CPU backend the mirror has nothing to compare with, and invariants still run",
                 "[planted]") {
    app::Session session(options_for(test::shader_folder(), SortMethod::bitonic, "cpu"), true, "4.3");
    app::LiveCheck check(session);
    check.set_mode(ui::LiveCheckMode::mirror);
    session.forward(StepUnit::step);
    const ui::LiveCheckState state = state_of(check);
    CHECK(state.mirror_computes);
    for (const Dispatch& dispatch : session.simulation().schedule().dispatches) {
        CHECK(ui::stage_badge(state, dispatch.stage).text == "promise kept");
    }
}

TEST_CASE_METHOD(GlFixture, "the check changes nothing: the same hash with and without, forth and back", "[planted]") {
    const auto run = [](ui::LiveCheckMode mode) {
        app::Session session(options_for(test::shader_folder(), SortMethod::bitonic_fused, "gpu"), true, "4.3");
        app::LiveCheck check(session);
        check.set_mode(mode);
        session.forward(StepUnit::step);
        session.forward(StepUnit::stage);
        session.forward(StepUnit::pass);
        session.back(StepUnit::substep);
        session.forward(StepUnit::substep);
        session.to_step_end();
        return hash_state(session.simulation().raw_state());
    };
    const std::uint64_t plain = run(ui::LiveCheckMode::off);
    CHECK(run(ui::LiveCheckMode::mirror) == plain);
    CHECK(run(ui::LiveCheckMode::invariants) == plain);
}
