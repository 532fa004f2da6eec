// Share codes: what goes in comes out, what is no code is one sentence, and the run that a code holds is the same run.
#include "app/share_code.h"

#include <memory>

#include "app/base64url.h"
#include "app/gallery.h"
#include "app/shared_run.h"
#include "core/scene_file.h"
#include "core/scene_writer.h"
#include "cpu/cpu_backend.h"
#include "support/catch.h"
#include "support/input_error.h"
#include "view/stb.h"

using namespace ballpit;
using namespace ballpit::app;

namespace {

std::vector<SceneEntry> gallery() { return list_scenes(std::filesystem::path(BALLPIT_SOURCE_DIR) / "assets"); }

SharedCode unusual_code() {
    SharedCode code;
    code.scene = "two_balls";
    code.scene_check = 0xFEDCBA9876543210u;
    code.seed = 18446744073709551615u;
    code.start = {{"balls", "1"}, {"laws", "gravity,contact"}};
    code.changes = {{{0, 0}, {{"drag", "0.3"}}, {}},
                    {{4, 2}, {}, {BallSpec{{0.1, -0.2, 0.3}, {1.0, 2.0, -30.0}, 0.07, 12.5, {}}}},
                    {{4, 2}, {{"gravity", "0,0,-1.6"}, {"substeps", "3"}}, {}}};
    code.substep = {7, 1};
    code.ran = 13;
    code.hash = 0x0123456789ABCDEFu;
    code.backend = "gpu";
    code.device = "A \"device\", ü";
    code.shown.view.colour = ui::BallColour::speed;
    code.shown.probe.arrows = true;
    code.shown.light.angle = 1.25f;
    code.camera = view::Camera{{1.0f, -2.5f, 0.1f}, 0.3f, -0.4f, 0.75f};
    code.ball = 3;
    return code;
}

std::string complaint(const std::string& text) {
    return test::complaint_of([&] { decode_share_code(text); });
}

std::string pack(const std::string& json) { return "ballpit1." + base64url(view::stb::deflate(json)); }

// A run as a user makes one: settings change between steps and within one, a ball is thrown in.
struct Run {
    explicit Run(const SharedScene& shared, std::uint64_t seed)
        : simulation(shared.scene, shared.settings, seed, std::make_unique<cpu::CpuBackend<float>>()) {}

    void change(void (*edit)(Settings&)) {
        Settings settings = simulation.settings();
        edit(settings);
        stepper.change(settings);
    }
    void play() {
        change([](Settings& s) { s.drag = 0.2; });
        stepper.forward(StepUnit::step);
        stepper.forward(StepUnit::step);
        stepper.forward(StepUnit::substep);
        change([](Settings& s) { s.gravity = {0.5, 0.0, 3.0}; });
        stepper.change(AddBalls{{BallSpec{{0.0, 0.0, 0.0}, {0.0, 1.0, 5.0}, 0.2, 3.0, {}}}});
        stepper.forward(StepUnit::step);
        change([](Settings& s) { s.integrator = Integrator::velocity_verlet; });
        change([](Settings& s) { s.balls -= 5; });
        stepper.forward(StepUnit::step);
        stepper.forward(StepUnit::substep);
        stepper.forward(StepUnit::pass);
    }

    Simulation simulation;
    Stepper stepper{simulation, std::size_t{1} << 24};
};

std::vector<std::pair<Moment, Change>> changes_of(const Stepper& stepper) {
    std::vector<std::pair<Moment, Change>> changes;
    for (const auto& [at, list] : stepper.timeline().changes()) {
        for (const Change& change : list) {
            changes.emplace_back(at, change);
        }
    }
    return changes;
}

}  // namespace

TEST_CASE("a share code holds what was put in", "[share]") {
    const SharedCode code = unusual_code();
    const std::string text = encode_share_code(code);
    CHECK(text.starts_with("ballpit1."));
    CHECK(text.find_first_of(" \n\"'\\+/=") == std::string::npos);
    const SharedCode again = decode_share_code("  " + text.substr(0, 30) + "\r\n " + text.substr(30) + "\n");
    CHECK(again.scene == code.scene);
    CHECK(again.scene_check == code.scene_check);
    CHECK(again.seed == code.seed);
    CHECK(again.start == code.start);
    REQUIRE(again.changes.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(again.changes[i].at == code.changes[i].at);
        CHECK(again.changes[i].settings == code.changes[i].settings);
        CHECK(again.changes[i].balls.size() == code.changes[i].balls.size());
    }
    CHECK(again.changes[1].balls[0].velocity == code.changes[1].balls[0].velocity);
    CHECK(again.changes[1].balls[0].mass == code.changes[1].balls[0].mass);
    CHECK(again.substep == code.substep);
    CHECK(again.ran == code.ran);
    CHECK(again.hash == code.hash);
    CHECK(again.device == code.device);
    CHECK(again.shown == code.shown);
    REQUIRE(again.camera);
    CHECK(again.camera->position == code.camera->position);
    CHECK(again.camera->yaw == code.camera->yaw);
    CHECK(again.ball == code.ball);
    CHECK_FALSE(again.cell);
    CHECK(encode_share_code(again) == text);
}

TEST_CASE("the run of a code is the same run, bit for bit, and stops at the same dispatch", "[share]") {
    SharedCode code;
    code.scene = "mixed_sizes";
    code.seed = 99;
    code.start = {{"balls", "120"}, {"substeps", "4"}};
    code.scene_check =
        scene_check(load_scene(find_scene(std::filesystem::path(BALLPIT_SOURCE_DIR) / "assets", code.scene)));
    Run run(shared_scene(code, gallery()), code.seed);
    const Settings start = run.simulation.settings();
    run.play();
    code.changes = shared_changes(start, changes_of(run.stepper));
    code.substep = run.stepper.position().moment;
    code.ran = run.stepper.position().dispatch;
    code.hash = awaited_hash(run.stepper, run.simulation);
    REQUIRE(code.hash);
    REQUIRE(code.ran == 1);
    REQUIRE(code.changes.size() == 5);

    const SharedCode sent = decode_share_code(encode_share_code(code));
    const SharedScene shared = shared_scene(sent, gallery());
    CHECK(shared.same);
    Run replayed(shared, sent.seed);
    Replay replay(sent.changes, sent.substep, sent.ran);
    int slices = 1;
    while (!replay.advance(replayed.stepper, replayed.simulation, 0.0)) {
        ++slices;
    }
    CHECK(slices > 5);  // a change or a step each
    CHECK(replayed.stepper.position() == run.stepper.position());
    CHECK(replayed.simulation.settings() == run.simulation.settings());
    CHECK(hash_state(replayed.simulation.raw_state()) == hash_state(run.simulation.raw_state()));
    CHECK(awaited_hash(replayed.stepper, replayed.simulation) == code.hash);
}

TEST_CASE("what is no share code is refused in one sentence", "[share]") {
    const std::string good = encode_share_code(unusual_code());
    CHECK(complaint("") == "the share code: expected a line that begins with 'ballpit1.', found nothing");
    CHECK(complaint("https://example.org/a/long/line") ==
          "the share code: expected a line that begins with 'ballpit1.', found 'https://example.org/'");
    CHECK(complaint("ballpit2.AAAA") ==
          "the share code: expected one of version 1, found 'ballpit2', which another version of Ball Pit reads");
    const std::string damaged = "the share code: expected a whole line, found one that is cut off or damaged";
    CHECK(complaint("ballpit1.") == damaged);
    CHECK(complaint("ballpit1.????") == damaged);
    for (std::size_t length = 9; length < good.size(); length += 7) {
        CHECK(complaint(good.substr(0, length)) == damaged);
    }
    CHECK(complaint(pack("[]")).starts_with("the share code"));
    CHECK(complaint(pack("{")).starts_with("the share code, line 1"));
    CHECK(complaint(pack(std::string(100000, '['))).starts_with("the share code"));
    const std::string whole = R"("seed": 1, "backend": "cpu", "device": "x")";
    const std::string scene = R"({"scene": "rain", "check": "0", )" + whole;
    CHECK(complaint(pack(scene + R"(, "set": {}, "changes": [], "at": [0, 0, 0]})")) == "accepted");
    CHECK(complaint(pack(scene + R"(, "set": {"colour": "red"}, "changes": [], "at": [0, 0, 0]})")).find("colour") !=
          std::string::npos);
    CHECK(
        complaint(pack(scene + R"(, "set": {}, "changes": [[0, 0, {"drag": "-1"}]], "at": [0, 0, 0]})")).find("drag") !=
        std::string::npos);
    CHECK(complaint(pack(scene + R"(, "set": {}, "changes": [[2, 0, {}], [1, 0, {}]], "at": [0, 0, 0]})")) ==
          "the share code, /changes/1: expected changes in the order of time, found a list of 3");
    CHECK(complaint(pack(scene + R"(, "set": {}, "changes": [[0, 0, [[0, 0, 0, 0, 0, 0, -1, 1]]]], "at": [0, 0, 0]})"))
              .starts_with("the share code, /changes/0/2/0/6: expected a number from 0.001"));
    CHECK(complaint(pack(scene + R"(, "set": {}, "changes": [], "at": [0, 0]})")).starts_with("the share code, /at"));
}

TEST_CASE("a code names a scene of the gallery, never a file", "[share]") {
    SharedCode code = unusual_code();
    code.start.clear();
    for (const char* name : {"snow", "../scenes/rain", "/etc/passwd", "rain.json"}) {
        code.scene = name;
        CHECK(test::complaint_of([&] { shared_scene(code, gallery()); }) ==
              "the share code: expected a scene of this gallery, found '" + std::string(name) + "'");
    }
    code.scene = "rain";
    CHECK_FALSE(shared_scene(code, gallery()).same);  // as its check says
    code.scene.clear();
    code.scene_text = "{ \"name\": ";
    CHECK(test::complaint_of([&] { shared_scene(code, gallery()); }).starts_with("the share code's scene, line 1"));
}

TEST_CASE("a moment before the start of a scene is refused", "[share]") {
    const SharedScene shared = [] {
        SharedCode code;
        code.scene = "two_balls";
        return shared_scene(code, gallery());
    }();
    Scene scene = shared.scene;
    scene.resume = Resume{};
    scene.resume->step = 10;
    Simulation simulation(scene, scene.settings, 0, std::make_unique<cpu::CpuBackend<float>>());
    Stepper stepper(simulation, std::size_t{1} << 20);
    Replay replay({}, {3, 0}, 0);
    CHECK(test::complaint_of([&] { replay.advance(stepper, simulation, 1.0); }) ==
          "the share code: its moment lies before the start of its scene");
}
