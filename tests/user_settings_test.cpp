// What the window remembers: it comes back as it was, and a file that cannot be used is set aside and told of.
#include "app/user_settings.h"

#include <fstream>
#include <iterator>
#if !defined(_WIN32)
#include <sys/resource.h>

#include <csignal>
#endif

#include "app/user_folders.h"
#include "app/window_start.h"
#include "support/catch.h"
#include "support/input_error.h"
#include "support/temporary_folder.h"

using namespace ballpit;
using namespace ballpit::app;

namespace {

namespace fs = std::filesystem;

UserSettings unusual_settings() {
    UserSettings settings;
    settings.place = WindowPlace{-1200, 40, 900, 600};
    settings.full_screen = true;
    settings.text_size = 1.25;
    settings.speed = 0.1;
    settings.backend = "cpu";
    settings.shown.emplace();
    settings.shown->view.colour = ui::BallColour::contacts;
    settings.shown->view.panels = false;
    settings.shown->probe.slice = true;
    settings.shown->probe.slice_axis = 0;
    settings.shown->probe.slot = Slot::keys;
    settings.shown->probe.arrow_seconds = 0.3f;
    settings.shown->light.colour = {0.1f, 0.9f, 0.3f};
    settings.shown->light.angle = 2.7182817f;
    settings.scene = "pile";
    settings.changed = {{"balls", "300"}, {"gravity", "0,0,-1.6"}};
    settings.seed = 18446744073709551615u;
    settings.layout = "[Window][Cells]\nPos=60,60\nSize=400,200\n";
    return settings;
}

void put(const fs::path& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

std::string text_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace

TEST_CASE("a scene comes back with the laws it was left with, and with what only these laws use", "[user-settings]") {
    UserSettings user;
    user.scene = "elastic_gas";  // has no drag
    user.changed = {{"drag", "0.25"}, {"laws", "drag,contact,walls"}};
    std::string message;
    const Setup setup = make_window_setup({}, user, message);
    CHECK(message.empty());
    CHECK(setup.scene.name == "Elastic gas");
    CHECK(setup.settings.laws.drag);
    CHECK(setup.settings.drag == 0.25);
}

TEST_CASE("a scene that cannot come back is told of, and the usual one opens", "[user-settings]") {
    UserSettings user;
    user.scene = "elastic_gas";
    user.changed = {{"stiffness", "-1"}};
    std::string message;
    CHECK(make_window_setup({}, user, message).scene.name == "Rain");
    CHECK(message.find("stiffness") != std::string::npos);
}

TEST_CASE("what the window remembers comes back as it was", "[user-settings]") {
    const test::TemporaryFolder home;
    const fs::path folder = home.path() / "a" / "ballpit";
    CHECK(load_user_settings(folder).message.empty());
    CHECK(load_user_settings(folder).settings == UserSettings{});
    for (const UserSettings& settings : {UserSettings{}, unusual_settings()}) {
        save_user_settings(folder, settings);
        const LoadedSettings loaded = load_user_settings(folder);
        CHECK(loaded.message.empty());
        CHECK(loaded.settings == settings);
    }
}

TEST_CASE("a settings file that cannot be used is set aside, and nothing of it is lost", "[user-settings]") {
    const test::TemporaryFolder home;
    const fs::path file = home.path() / "settings.json";
    const std::string good = R"({"program": "ballpit", )";
    int n = 0;
    for (const std::string& bad :
         {std::string(), std::string("{"), std::string("[]"), std::string("{\"program\": \"other\"}"),
          std::string("\x00\xFF\x13", 3), std::string("{}"), good + R"("text_size": 1e9})",
          good + R"("text_size": "big"})", good + R"("window": {"x": 1}})",
          good + R"("shown": {"view": {"look": "shiny"}}})", good + R"("shown": 3})", good + R"("shown": {"view": 3}})",
          good + R"("settings": []})"}) {
        put(file, bad);
        const LoadedSettings loaded = load_user_settings(home.path());
        ++n;
        CAPTURE(bad, loaded.message);
        CHECK(loaded.settings == UserSettings{});
        CHECK(loaded.message.find("settings.json") != std::string::npos);
        CHECK(loaded.message.find("It is now settings.json.bad-" + std::to_string(n)) != std::string::npos);
        CHECK_FALSE(fs::exists(file));
        CHECK(text_of(home.path() / ("settings.json.bad-" + std::to_string(n))) == bad);
    }
}

TEST_CASE("settings of another version are passed over", "[user-settings]") {
    const test::TemporaryFolder home;
    put(home.path() / "settings.json",
        R"({"program": "ballpit", "news": 1, "speed": 2, "settings": {"balls": "7", "colour": "red"}})");
    const LoadedSettings loaded = load_user_settings(home.path());
    CHECK(loaded.message.empty());
    CHECK(loaded.settings.speed == 2.0);
    CHECK(loaded.settings.changed == std::map<std::string, std::string>{{"balls", "7"}});
}

TEST_CASE("a folder that cannot be written is one sentence", "[user-settings]") {
    const test::TemporaryFolder home;
    put(home.path() / "file", "in the way");
    const std::string complaint =
        test::complaint_of([&] { save_user_settings(home.path() / "file" / "ballpit", UserSettings{}); });
    CHECK(complaint.find("settings.json: cannot be written") != std::string::npos);
    CHECK(test::complaint_of([] { save_user_settings({}, UserSettings{}); }).find("home folder") != std::string::npos);
}

#if !defined(_WIN32)
namespace {

/// No file grows beyond as many bytes, as on a full disk.
class FullDisk {
public:
    explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FullDisk() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

private:
    rlimit before_{};
    void (*handler_)(int);
};

}  // namespace

TEST_CASE("a full disk leaves the settings of before", "[user-settings]") {
    const test::TemporaryFolder home;
    UserSettings settings;
    settings.scene = "pile";
    settings.layout = "as it was";
    save_user_settings(home.path(), settings);
    const std::string before = text_of(home.path() / "settings.json");
    settings.scene = "rain";
    settings.layout = std::string(10000, 'x');
    for (const rlim_t room : {rlim_t{10}, rlim_t{5000}}) {  // the second one only for the first file
        const FullDisk disk(room);
        const std::string complaint = test::complaint_of([&] { save_user_settings(home.path(), settings); });
        CHECK(complaint.find("is the disk full?") != std::string::npos);
        CHECK((text_of(home.path() / "settings.json") == before) == (room == 10));
    }
    const LoadedSettings loaded = load_user_settings(home.path());
    CHECK(loaded.message.empty());
    CHECK(loaded.settings.scene == "rain");
    CHECK(loaded.settings.layout == "as it was");
    CHECK(std::distance(fs::directory_iterator(home.path()), fs::directory_iterator()) == 2);
}
#endif

#if !defined(_WIN32) && !defined(__APPLE__)
TEST_CASE("folders follow the XDG rules", "[user-settings]") {
    const auto set = [](const char* name, const char* value) {
        value == nullptr ? unsetenv(name) : setenv(name, value, 1);
    };
    const char* home = std::getenv("HOME");
    const std::string before = home == nullptr ? "" : home;
    set("HOME", "/home/eve");
    set("XDG_CONFIG_HOME", nullptr);
    CHECK(config_folder() == "/home/eve/.config/ballpit");
    set("XDG_CONFIG_HOME", "relative");
    CHECK(config_folder() == "/home/eve/.config/ballpit");
    set("XDG_CONFIG_HOME", "/etc/eve");
    CHECK(config_folder() == "/etc/eve/ballpit");
    set("XDG_DATA_HOME", nullptr);
    CHECK(data_folder() == "/home/eve/.local/share/ballpit");
    set("XDG_CONFIG_HOME", nullptr);
    set("HOME", nullptr);
    CHECK(config_folder().empty());
    set("HOME", before.c_str());
}
#endif
