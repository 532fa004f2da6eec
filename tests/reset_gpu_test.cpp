// The driver is reset while something runs: nothing hangs, one sentence, and what the user has set is kept. The plug is
// pulled by a status function in the driver's place.
#include "gl/reset.h"

#include <cstdlib>

#include "app/commands.h"
#include "app/user_settings.h"
#include "app/window.h"
#include "core/error.h"
#include "core/scene_file.h"
#include "support/catch.h"
#include "support/gl_fixture.h"
#include "support/gpu_backend.h"
#include "support/scenes.h"
#include "support/temporary_folder.h"

using namespace ballpit;
using test::GlFixture;

namespace {

constexpr GLenum guilty = 0x8253;
constexpr GLenum innocent = 0x8254;

/// The driver is well for as many questions, then tells of a reset, then, as drivers do, that all is well again.
class PulledPlug {
public:
    explicit PulledPlug(int answers, GLenum status = innocent) {
        gl::replace_reset_status([left = answers, status]() mutable {
            --left;
            return left == -1 ? status : static_cast<GLenum>(GL_NO_ERROR);
        });
    }
    ~PulledPlug() { gl::replace_reset_status({}); }
    PulledPlug(const PulledPlug&) = delete;
    PulledPlug& operator=(const PulledPlug&) = delete;
};

/// Commands and windows have contexts of their own; the tests' is current again at the end.
class ContextKept {
public:
    ContextKept() = default;
    ~ContextKept() { SDL_GL_MakeCurrent(test::context().window(), test::context().handle()); }
    ContextKept(const ContextKept&) = delete;
    ContextKept& operator=(const ContextKept&) = delete;
};

std::string refusal_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const DeviceError& error) {
        return error.what();
    } catch (const gl::Lost& error) {
        return error.what();
    }
    return "";
}

bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE_METHOD(GlFixture, "a driver that is well resets nothing", "[gpu-backend]") {
    CHECK_FALSE(gl::reset_reason());
    CHECK_NOTHROW(gl::expect_context());
}

TEST_CASE_METHOD(GlFixture, "a reset is remembered though the driver recovers", "[gpu-backend]") {
    const PulledPlug plug(1, guilty);
    CHECK_FALSE(gl::reset_reason());
    for (int i = 0; i < 3; ++i) {
        CHECK(contains(gl::reset_reason().value(), "something that this program asked for"));
    }
    CHECK_THROWS_AS(gl::expect_context(), gl::Lost);
}

TEST_CASE_METHOD(GlFixture, "who waits for a lost device does not wait for ever", "[gpu-backend]") {
    const auto backend = test::gpu_backend();
    const PulledPlug plug(0);
    CHECK_THROWS_AS(backend->finish(), gl::Lost);
    CHECK_THROWS_AS(backend->read(Slot::positions), gl::Lost);
}

TEST_CASE_METHOD(GlFixture, "a headless run on a device that is lost ends, and writes nothing", "[gpu-backend]") {
    const ContextKept kept;
    const test::TemporaryFolder folder;
    setenv("BALLPIT_HOME", BALLPIT_SOURCE_DIR, 1);
    app::Options options;
    options.command = app::Command::headless;
    options.backend = "gpu";
    options.scene = "two_balls";
    options.steps = 1000000;
    options.state_out = (folder.path() / "state.csv").string();
    options.trace = (folder.path() / "trace.csv").string();
    options.json = (folder.path() / "report.json").string();
    const PulledPlug plug(100);
    const std::string message = refusal_of([&] { app::run_headless(options); });
    CHECK(contains(message, "reset, because of another program"));
    CHECK(contains(message, "no file was written"));
    CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE_METHOD(GlFixture, "a window on a device that is lost keeps what the user has set", "[gpu-backend]") {
    const ContextKept kept;
    const test::TemporaryFolder folder;
    setenv("XDG_DATA_HOME", folder.path().c_str(), 1);
    app::WindowOptions options;
    options.scene = test::shipped_scene("rain");
    options.scene_file = (test::source_folder() / "assets/scenes/rain.json").string();
    options.gallery = app::list_scenes(test::source_folder() / "assets");
    options.settings = options.scene.settings;
    options.settings.balls = 200;
    options.settings.drag = 0.75;
    options.seed = 7;
    options.assets_folder = test::source_folder() / "assets";
    options.shader_folder = test::shader_folder();
    options.model_file = test::source_folder() / "assets/models/ball.obj";
    options.width = 320;
    options.height = 240;
    options.user_folder = folder.path() / "settings";
    const PulledPlug plug(30);
    const std::string message = refusal_of([&] { app::run_window(options); });
    unsetenv("XDG_DATA_HOME");
    const auto saved = folder.path() / "ballpit" / "before_reset.json";
    CHECK(contains(message, "reset, because of another program"));
    CHECK(contains(message, "Settings are kept, and the scene as it was set is in " + saved.string()));
    const Scene scene = load_scene(saved);
    CHECK(scene.name == options.scene.name);
    CHECK(scene.settings.drag == 0.75);
    CHECK(scene.settings.balls == 200);
    CHECK(scene.fill->seed == 7);
    const app::LoadedSettings user = app::load_user_settings(options.user_folder);
    CHECK(user.message.empty());
    CHECK(user.settings.scene == "rain");
    CHECK(user.settings.changed.at("drag") == "0.75");
}
