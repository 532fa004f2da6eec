// Scene files: what is accepted, and what absent parts stand for.
#include "core/scene_file.h"

#include <array>
#include <bit>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/random.h"
#include "core/world.h"
#include "support/catch.h"
#include "support/scene_text.h"
#include "support/scenes.h"

using namespace ballpit;
using test::complaint;
using test::scene_with;
using test::with_laws;

namespace {

template <class Number>
std::string shortest(Number value) {
    std::array<char, 32> text{};
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

}  // namespace

TEST_CASE("a scene file is read whole", "[core]") {
    const Scene scene = parse_scene(scene_with("N", "N"), "s.json");
    CHECK(scene.name == "N");
    CHECK(scene.about == "A.");
    CHECK(scene.half_extent == dvec3(1, 2, 3));
    CHECK(scene.reference_count == 10);
    CHECK((scene.settings.laws.gravity && scene.settings.laws.drag && scene.settings.laws.contact &&
           scene.settings.laws.restitution && scene.settings.laws.walls));
    CHECK(scene.settings.gravity == dvec3(0, 0, -9.8));
    CHECK(scene.settings.drag == 0.1);
    CHECK(scene.settings.stiffness == 1000);
    CHECK(scene.settings.restitution == 0.9);
    CHECK(scene.settings.limit_force);
    CHECK(scene.settings.dt == 0.01);
    CHECK(scene.settings.substeps == 4);
    CHECK(scene.settings.integrator == Integrator::historical);
    REQUIRE(scene.balls.size() == 1);
    CHECK(scene.balls[0].position == dvec3(0, 0, 1));
    CHECK(scene.balls[0].velocity == dvec3(1, 0, 0));
    CHECK(scene.balls[0].radius == 0.5);
    CHECK(scene.balls[0].mass == 2);
    CHECK(scene.balls[0].restitution == 0.8);
    REQUIRE(scene.fill);
    CHECK(scene.fill->count == 7);
    CHECK(scene.fill->radius == std::array{0.1, 0.2});
    CHECK(scene.fill->density == 500);
    CHECK(scene.fill->speed == 3);
    CHECK(scene.fill->region == std::array{dvec3(-1, -2, 0), dvec3(1, 2, 3)});
    CHECK(scene.fill->seed == 42);
    CHECK(scene.settings.balls == 8);
}

TEST_CASE("what is absent is not modelled, or has its default", "[core]") {
    const Scene scene = parse_scene(
        R"({"name": "N", "box": {"half_extent": [1, 1, 1]}, "fill": {"count": 3, "radius": [0.1, 0.1]}})", "s.json");
    CHECK(scene.about.empty());
    CHECK(laws_text(scene.settings.laws) == "diagnostics");
    CHECK(scene.reference_count == 0);
    CHECK(scene.settings.dt == Settings{}.dt);
    CHECK(scene.settings.substeps == Settings{}.substeps);
    CHECK(scene.settings.integrator == Integrator::leapfrog);
    CHECK(scene.fill->density == 1000);
    CHECK(scene.fill->speed == 0);
    CHECK(scene.fill->seed == 0);
    CHECK(scene.fill->region == std::array{dvec3(-1), dvec3(1)});
    CHECK(scene.settings.balls == 3);
}

TEST_CASE("a contact without restitution loses nothing", "[core]") {
    const Scene scene = parse_scene(scene_with(R"("restitution": 0.9, )", ""), "s.json");
    CHECK(scene.settings.laws.contact);
    CHECK_FALSE(scene.settings.laws.restitution);
    CHECK(scene.settings.restitution == 1.0);
}

TEST_CASE("walls have a stiffness of their own where balls do not touch", "[core]") {
    const Scene scene = with_laws(R"("walls": { "stiffness": 500, "restitution": 0.7, "limit_force": false })");
    CHECK(scene.settings.laws.walls);
    CHECK(scene.settings.laws.restitution);
    CHECK_FALSE(scene.settings.laws.contact);
    CHECK(scene.settings.stiffness == 500);
    CHECK(scene.settings.restitution == 0.7);
    CHECK_FALSE(scene.settings.limit_force);
    CHECK_FALSE(with_laws(R"("walls": { "stiffness": 500 })").settings.laws.restitution);
    CHECK_FALSE(with_laws(R"("walls": false)").settings.laws.walls);
}

TEST_CASE("a box that is shaken, diagnostics that are off", "[core]") {
    const Scene scene =
        with_laws(R"("walls": { "stiffness": 1 }, "shake": { "amplitude": [0.1, 0, -0.2], "frequency": 3 })");
    CHECK(scene.settings.laws.shake);
    CHECK(scene.settings.shake_amplitude == dvec3(0.1, 0, -0.2));
    CHECK(scene.settings.shake_frequency == 3);
    CHECK(scene.settings.laws.diagnostics);
    CHECK_FALSE(with_laws(R"("diagnostics": false)").settings.laws.diagnostics);
}

TEST_CASE("where the walls shall go, and how the stages are computed", "[core]") {
    const Scene scene = parse_scene(scene_with(R"("reference_count": 10 },)",
                                               R"("walls_low": [0, 0, 1], "walls_high": [-1, 0, 0], "wall_speed": 0.5 },
                      "compute": { "sort": "bitonic", "cell_factor": 0.5, "grid_reuse": 4,
                                   "neighbours": "brute_force" },)"),
                                    "s.json");
    CHECK(scene.settings.walls_low == dvec3(0, 0, 1));
    CHECK(scene.settings.walls_high == dvec3(-1, 0, 0));
    CHECK(scene.settings.wall_speed == 0.5);
    CHECK(scene.settings.sort == SortMethod::bitonic);
    CHECK(scene.settings.cell_factor == 0.5);
    CHECK(scene.settings.grid_reuse == 4);
    CHECK(scene.settings.neighbours == NeighbourSearch::brute_force);
}

TEST_CASE("a saved moment is read whole, and its balls may be anywhere", "[core]") {
    const std::string moment = R"("resume": { "step": 18446744073709551615, "time": 1.5, "velocity_lag": 0.001,
        "walls_low": [1, 2, 3], "walls_high": [-1, -2, -3], "shake_offset": [0, 0, 0.1], "shake_phase": 6 }, )";
    const std::string gone = R"("position": [0, 0, -700.5], "velocity": [1e7, 0, -0])";
    const std::string text = scene_with(R"("position": [0, 0, 1], "velocity": [1, 0, 0])", gone);
    CHECK(complaint(text) == "s.json, /balls/0/velocity/0: expected a number from -1e+06 to 1e+06 m/s, found 1e+07");
    CHECK(complaint(text.substr(0, text.find("1e7")) + "0" + text.substr(text.find("1e7") + 3)) ==
          "s.json, /balls/0/position/2: expected a place inside the box, from -3 to 3 m, found -700.5");
    const Scene scene = parse_scene("{" + moment + text.substr(1), "s.json");
    REQUIRE(scene.resume);
    CHECK(scene.resume->step == 18446744073709551615ull);
    CHECK(scene.resume->time == 1.5);
    CHECK(scene.resume->velocity_lag == 0.001);
    CHECK(scene.resume->walls.low == dvec3(1, 2, 3));
    CHECK(scene.resume->walls.high == dvec3(-1, -2, -3));
    CHECK(scene.resume->walls.shake == dvec3(0, 0, 0.1));
    CHECK(scene.resume->walls.shake_phase == 6);
    CHECK(scene.balls[0].position.z == -700.5);
    CHECK(scene.balls[0].velocity.x == 1e7);
    CHECK(std::signbit(scene.balls[0].velocity.z));
}

TEST_CASE("what a scene promises", "[core]") {
    const std::string text = scene_with("N", "N");
    CHECK_FALSE(parse_scene(text, "s.json").bounds);
    const Scene scene =
        parse_scene(R"({"bounds": {"speed": 20, "overlap": 0.1, "outside": 2},)" + text.substr(1), "s.json");
    REQUIRE(scene.bounds);
    CHECK(scene.bounds->speed == 20);
    CHECK(scene.bounds->overlap == 0.1);
    CHECK(scene.bounds->outside == 2);
    CHECK(parse_scene(R"({"bounds": {"speed": 20},)" + text.substr(1), "s.json").bounds->outside == 0);
}

TEST_CASE("every float that is written in full comes back the same", "[core]") {
    std::vector<float> floats = {0.1f, -0.0f, 1.0f / 3.0f, 16777216.0f, -123456.789f, 1.17549435e-38f, 1.4e-45f};
    for (std::uint64_t i = 0; i < 300; ++i) {
        floats.push_back(static_cast<float>(std::exp2(60.0 * random_unit(1, 0, i) - 40.0) * (i % 2 == 0 ? 1.0 : -1.0)));
    }
    std::string balls;
    for (const float value : floats) {
        balls += (balls.empty() ? "" : ",") + (R"({"position": [0, 0, 0], "radius": 1, "mass": 1, "velocity": [)" +
                                               shortest(value) + "," + shortest(static_cast<double>(value)) + ",0]}");
    }
    const Scene scene = parse_scene(
        R"({"name": "N", "box": {"half_extent": [1, 1, 1]}, "resume": {}, "balls": [)" + balls + "]}", "s.json");
    REQUIRE(scene.balls.size() == floats.size());
    for (std::size_t i = 0; i < floats.size(); ++i) {
        CAPTURE(floats[i]);
        CHECK(std::bit_cast<std::uint32_t>(static_cast<float>(scene.balls[i].velocity.x)) ==
              std::bit_cast<std::uint32_t>(floats[i]));
        CHECK(std::bit_cast<std::uint32_t>(static_cast<float>(scene.balls[i].velocity.y)) ==
              std::bit_cast<std::uint32_t>(floats[i]));
    }
}

TEST_CASE("balls may be listed before what they depend on", "[core]") {
    const std::string start = R"({"balls": [{"position": [0, 0, 2], "radius": 1, "mass": 1}], "name": "N",)";
    CHECK(complaint(start + R"("box": {"half_extent": [1, 1, 3]}})") == "accepted");
    CHECK(complaint(start + R"("box": {"half_extent": [1, 1, 1]}})") ==
          "s.json, /balls/0/position/2: expected a place inside the box, from -1 to 1 m, found 2");
    CHECK(complaint(R"({"name": "N", "balls": [[]]})") == "s.json, /balls/0: expected an object, found a list of 0");
    CHECK(complaint(R"({"name": "N", "balls": [{"mass": {"a": 1, "a": 1}}]})") ==
          "s.json, /balls/0/mass/a: expected every key once, found this one twice");
}

TEST_CASE("more balls than there can be are refused where they begin", "[core]") {
    std::string text = R"({"name": "N", "box": {"half_extent": [1, 1, 1]}, "balls": [)";
    const std::string ball = R"({"position":[0,0,0],"radius":1,"mass":1},)";
    text.reserve(text.size() + (maximum_balls + 2) * ball.size());
    for (std::uint32_t i = 0; i <= maximum_balls; ++i) {
        text += ball;
    }
    text.back() = ']';
    CHECK(complaint(text + "}") == "s.json, /balls/4194304: expected at most 4194304 balls, found one more");
}

TEST_CASE("the largest seed is kept to the last bit, and a byte order mark is no error", "[core]") {
    CHECK(parse_scene(scene_with("42", "18446744073709551615"), "s.json").fill->seed == 18446744073709551615ull);
    CHECK(parse_scene("\xEF\xBB\xBF" + scene_with("N", "N"), "s.json").name == "N");
    CHECK(parse_scene(scene_with("\"N\"", "\"N\u00fcr\u4e00\\u00e9\""), "s.json").name == "N\u00fcr\u4e00\u00e9");
}

TEST_CASE("every scene that ships can be read, and its fill finds room", "[core]") {
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(test::source_folder() / "assets" / "scenes")) {
        if (entry.path().filename() == "scene.schema.json") {
            continue;
        }
        const Scene scene = load_scene(entry.path());
        CAPTURE(entry.path().string());
        CHECK_FALSE(scene.about.empty());
        const World world = make_world(scene, scene.settings.balls, test::seed_of(scene));
        CHECK((world.overlapping == 0 || entry.path().stem() == "one_cell"));
        ++files;
    }
    CHECK(files == test::shipped_scene_names.size());
}

TEST_CASE("the example in the documentation is a scene", "[core]") {
    std::ifstream file(test::source_folder() / "docs" / "scenes.md");
    const std::string page{std::istreambuf_iterator<char>(file), {}};
    const std::size_t start = page.find("```json\n") + 8;
    const std::size_t end = page.find("```", start);
    REQUIRE(end != std::string::npos);
    const Scene scene = parse_scene(page.substr(start, end - start), "docs/scenes.md");
    CHECK(scene.settings.balls == 5002);
    CHECK((scene.settings.laws.gravity && scene.settings.laws.drag && scene.settings.laws.contact &&
           scene.settings.laws.restitution && scene.settings.laws.walls));
}
