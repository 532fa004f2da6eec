#include "app/user_settings.h"

#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/atomic_file.h"
#include "core/error.h"
#include "core/settings.h"

namespace ballpit::app {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::uintmax_t largest_file = 1u << 20;  // bytes; ours have a few thousand
constexpr double most_points = 100000.0;

fs::path settings_file(const fs::path& folder) { return folder / "settings.json"; }
fs::path layout_file(const fs::path& folder) { return folder / "layout.ini"; }

std::string read_text(const fs::path& file) {
    std::error_code error;
    if (!fs::is_regular_file(file, error) || fs::file_size(file, error) > largest_file) {
        throw InputError(file.string() + ": expected a file of at most 1 MiB");
    }
    std::ifstream stream(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (!stream) {
        throw InputError(file.string() + ": cannot be read");
    }
    return text;
}

int whole_number(const JsonValue& object, std::string_view key, double low) {
    return static_cast<int>(object.required(key).number_between(low, most_points, "points"));
}

WindowPlace read_place(const JsonValue& value) {
    constexpr double smallest = 200.0;
    value.expect_object();
    return {whole_number(value, "x", -most_points), whole_number(value, "y", -most_points),
            whole_number(value, "width", smallest), whole_number(value, "height", smallest)};
}

// A setting that the program no longer has, or not yet, is no reason to forget the others.
std::map<std::string, std::string> read_changed(const JsonValue& list) {
    std::map<std::string, std::string> changed;
    for (const SettingInfo& info : setting_table()) {
        if (const auto value = list.optional(info.key)) {
            changed.emplace(info.key, value->string());
        }
    }
    return changed;
}

UserSettings parse(const std::string& text, const std::string& file) {
    const json tree = parse_json(text, file);
    const JsonValue root(tree, file);
    root.expect_object();
    if (root.required("program").string() != "ballpit") {
        root.required("program").refuse("\"ballpit\"");
    }
    UserSettings settings;
    if (const auto place = root.optional("window")) {
        settings.place = read_place(*place);
    }
    if (const auto full = root.optional("full_screen")) {
        settings.full_screen = full->boolean();
    }
    if (const auto size = root.optional("text_size")) {
        settings.text_size = size->number_between(ui::smallest_text, ui::largest_text, "");
    }
    if (const auto speed = root.optional("speed")) {
        settings.speed = speed->number_between(ui::slowest_time, ui::fastest_time, "");
    }
    if (const auto backend = root.optional("backend")) {
        settings.backend = backend->string();
    }
    if (const auto shown = root.optional("shown")) {
        shown->expect_object();
        settings.shown = read_shown(*shown);
    }
    if (const auto scene = root.optional("scene")) {
        settings.scene = scene->string();
    }
    if (const auto seed = root.optional("seed")) {
        settings.seed = seed->whole_number(std::numeric_limits<std::uint64_t>::max());
    }
    if (const auto changed = root.optional("settings")) {
        changed->expect_object();
        settings.changed = read_changed(*changed);
    }
    return settings;
}

json to_json(const UserSettings& settings) {
    json root{{"program", "ballpit"},        {"full_screen", settings.full_screen}, {"text_size", settings.text_size},
              {"speed", settings.speed},     {"backend", settings.backend},         {"scene", settings.scene},
              {"settings", settings.changed}};
    if (settings.place) {
        const WindowPlace& place = *settings.place;
        root["window"] = {{"x", place.x}, {"y", place.y}, {"width", place.width}, {"height", place.height}};
    }
    if (settings.shown) {
        root["shown"] = shown_json(*settings.shown);
    }
    if (settings.seed) {
        root["seed"] = *settings.seed;
    }
    return root;
}

// The sentence that tells what became of the file.
std::string set_aside(const fs::path& file, const std::string& reason) {
    std::error_code error;
    for (int n = 1; n < 1000; ++n) {
        fs::path aside = file;
        aside += ".bad-" + std::to_string(n);
        if (fs::exists(fs::symlink_status(aside, error))) {
            continue;
        }
        fs::rename(file, aside, error);
        return error ? reason + ". It could not be set aside: " + error.message() + "."
                     : reason + ". It is now " + aside.filename().string() + ", and the window starts as usual.";
    }
    return reason + ".";
}

void write(const fs::path& path, const std::string& text) {
    AtomicFile file(path);
    file.stream() << text;
    file.commit();
}

}  // namespace

LoadedSettings load_user_settings(const fs::path& folder) {
    LoadedSettings loaded;
    const fs::path file = settings_file(folder);
    std::error_code error;
    if (folder.empty() || !fs::exists(fs::symlink_status(file, error))) {
        return loaded;
    }
    try {
        loaded.settings = parse(read_text(file), file.string());
    } catch (const InputError& refusal) {
        loaded.message = set_aside(file, refusal.what());
        return loaded;
    }
    if (fs::exists(layout_file(folder), error)) {
        try {
            loaded.settings.layout = read_text(layout_file(folder));
        } catch (const InputError& refusal) {
            loaded.message = set_aside(layout_file(folder), refusal.what());
        }
    }
    return loaded;
}

void save_user_settings(const fs::path& folder, const UserSettings& settings) {
    if (folder.empty()) {
        throw InputError("settings cannot be kept: expected a home folder, found none");
    }
    std::error_code error;
    fs::create_directories(folder, error);  // what is wrong with it, writing tells
    write(settings_file(folder), to_json(settings).dump(2, ' ', false, json::error_handler_t::replace) + "\n");
    write(layout_file(folder), settings.layout);
}

}  // namespace ballpit::app
