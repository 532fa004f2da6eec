#include "app/share_code.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/base64url.h"
#include "app/report.h"
#include "core/error.h"
#include "core/hash.h"
#include "core/json_document.h"
#include "core/scene_sections.h"
#include "core/scene_writer.h"
#include "core/settings.h"
#include "view/stb.h"

namespace ballpit::app {

namespace {

using nlohmann::json;

constexpr std::string_view family = "ballpit";
constexpr std::string_view prefix = "ballpit1.";
constexpr std::size_t most_json = std::size_t{64} << 20;  // bytes that a code may unfold to
constexpr std::uint64_t most_steps = std::uint64_t{1} << 40;
constexpr std::uint64_t most_substeps = 1024;
constexpr std::uint64_t any_number = std::numeric_limits<std::uint32_t>::max();
const std::string place = "the share code";

json texts_json(const SettingTexts& texts) {
    json object = json::object();
    for (const auto& [key, value] : texts) {
        object[key] = value;
    }
    return object;
}

json ball_json(const BallSpec& ball) {
    return {ball.position.x, ball.position.y, ball.position.z, ball.velocity.x,
            ball.velocity.y, ball.velocity.z, ball.radius,     ball.mass};
}

constexpr const char* relax_name = "relax";

json change_json(const SharedChange& change) {
    json entry = {change.at.step, change.at.substep, texts_json(change.settings)};
    if (change.relax) {
        entry[2] = relax_name;
    } else if (!change.balls.empty()) {
        entry[2] = json::array();
        for (const BallSpec& ball : change.balls) {
            entry[2].push_back(ball_json(ball));
        }
    }
    return entry;
}

json to_json(const SharedCode& code) {
    json root = shown_json(code.shown);
    if (code.scene.empty()) {
        root["text"] = code.scene_text;
    } else {
        root["scene"] = code.scene;
        root["check"] = hash_text(code.scene_check);
    }
    root["seed"] = code.seed;
    root["set"] = texts_json(code.start);
    root["changes"] = json::array();
    for (const SharedChange& change : code.changes) {
        root["changes"].push_back(change_json(change));
    }
    root["at"] = {code.substep.step, code.substep.substep, code.ran};
    root["backend"] = code.backend;
    root["device"] = code.device;
    if (code.hash) {
        root["hash"] = hash_text(*code.hash);
    }
    if (code.camera) {
        root["camera"] = camera_json(*code.camera);
    }
    if (code.ball) {
        root["ball"] = *code.ball;
    }
    if (code.cell) {
        root["cell"] = *code.cell;
    }
    return root;
}

// Each value is tried on settings that nobody uses: a code that would be refused half-way is refused here.
SettingTexts read_texts(const JsonValue& object) {
    object.expect_object();
    SettingTexts texts;
    Settings tried;
    for (const std::string& key : object.keys()) {
        texts.emplace_back(key, object.required(key).string());
        assign_setting(tried, key, texts.back().second);
    }
    return texts;
}

BallSpec read_ball(const JsonValue& list) {
    if (list.expect_array() != 8) {
        list.refuse("a list of eight numbers");
    }
    constexpr double any = 1e12;
    const auto number = [&](std::size_t i) { return list.element(i).number_between(-any, any, ""); };
    BallSpec ball;
    ball.position = {number(0), number(1), number(2)};
    ball.velocity = {number(3), number(4), number(5)};
    ball.radius = list.element(6).number_between(smallest_length, largest_length, "m");
    ball.mass = list.element(7).number_between(smallest_mass, largest_mass, "kg");
    return ball;
}

Moment read_moment(const JsonValue& list) {
    return {list.element(0).whole_number(most_steps),
            static_cast<std::uint32_t>(list.element(1).whole_number(most_substeps))};
}

SharedChange read_change(const JsonValue& list) {
    if (list.expect_array() != 3) {
        list.refuse("a list of step, substep and change");
    }
    SharedChange change{read_moment(list), {}, {}};
    const JsonValue what = list.element(2);
    if (what.is_string()) {
        if (what.string() != relax_name) {
            what.refuse("relax");
        }
        change.relax = true;
        return change;
    }
    if (what.is_object()) {
        change.settings = read_texts(what);
        return change;
    }
    for (std::size_t i = 0; i < what.expect_array(); ++i) {
        change.balls.push_back(read_ball(what.element(i)));
    }
    return change;
}

std::uint64_t read_hash(const JsonValue& value) {
    const std::string text = value.string();
    std::uint64_t hash = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), hash, 16);
    if (error != std::errc{} || end != text.data() + text.size()) {
        value.refuse("hexadecimal digits");
    }
    return hash;
}

std::optional<std::uint32_t> read_number(const JsonValue& root, std::string_view key) {
    const auto value = root.optional(key);
    return value ? std::optional(static_cast<std::uint32_t>(value->whole_number(any_number))) : std::nullopt;
}

void read_scene(const JsonValue& root, SharedCode& code) {
    if (const auto text = root.optional("text")) {
        code.scene_text = text->string();
        return;
    }
    code.scene = root.required("scene").string();
    code.scene_check = read_hash(root.required("check"));
}

void read_changes(const JsonValue& list, SharedCode& code) {
    for (std::size_t i = 0; i < list.expect_array(); ++i) {
        code.changes.push_back(read_change(list.element(i)));
        if (i > 0 && code.changes[i].at < code.changes[i - 1].at) {
            list.element(i).refuse("changes in the order of time");
        }
    }
}

void read_position(const JsonValue& at, SharedCode& code) {
    if (at.expect_array() != 3) {
        at.refuse("a list of step, substep and dispatches");
    }
    code.substep = read_moment(at);
    code.ran = static_cast<std::uint32_t>(at.element(2).whole_number(any_number));
}

SharedCode from_json(const json& tree) {
    const JsonValue root(tree, place);
    root.expect_object();
    SharedCode code;
    read_scene(root, code);
    code.seed = root.required("seed").whole_number(std::numeric_limits<std::uint64_t>::max());
    code.start = read_texts(root.required("set"));
    read_changes(root.required("changes"), code);
    read_position(root.required("at"), code);
    code.backend = root.required("backend").string();
    code.device = root.required("device").string();
    if (const auto hash = root.optional("hash")) {
        code.hash = read_hash(*hash);
    }
    if (const auto camera = root.optional("camera")) {
        code.camera = read_camera(*camera);
    }
    code.ball = read_number(root, "ball");
    code.cell = read_number(root, "cell");
    code.shown = read_shown(root);
    return code;
}

std::string without_space(std::string_view text) {
    std::string letters;
    std::ranges::copy_if(text, std::back_inserter(letters),
                         [](char c) { return c != ' ' && c != '\n' && c != '\r' && c != '\t'; });
    return letters;
}

}  // namespace

SettingTexts setting_differences(const Settings& from, const Settings& to) {
    SettingTexts texts;
    for (const SettingInfo& info : setting_table()) {
        std::string text = setting_text(info, to);
        if (text != setting_text(info, from)) {
            texts.emplace_back(info.key, std::move(text));
        }
    }
    return texts;
}

void assign_settings(Settings& settings, const SettingTexts& texts) {
    for (const auto& [key, value] : texts) {
        assign_setting(settings, key, value);
    }
}

std::vector<SharedChange> shared_changes(const Settings& start, const std::vector<std::pair<Moment, Change>>& changes) {
    std::vector<SharedChange> shared;
    Settings before = start;
    for (const auto& [at, change] : changes) {
        if (const auto* settings = std::get_if<Settings>(&change)) {
            shared.push_back({at, setting_differences(before, *settings), {}});
            before = *settings;
        } else if (const auto* added = std::get_if<AddBalls>(&change)) {
            shared.push_back({at, {}, added->balls});
            before.balls += static_cast<std::uint32_t>(added->balls.size());
        } else {
            shared.push_back({at, {}, {}, true});
        }
    }
    return shared;
}

// Of the text of a scene file with its values.
std::uint64_t scene_check(const Scene& scene) {
    HashSum sum;
    std::uint32_t index = 0;
    for (const char letter : scene_text(scene)) {
        sum.add(static_cast<unsigned char>(letter), index++);
    }
    return sum.value();
}

std::string encode_share_code(const SharedCode& code) {
    const std::string text = to_json(code).dump(-1, ' ', false, json::error_handler_t::replace);
    if (text.size() > most_json) {
        throw InputError("the run is too long for a share code: save it as a scene file");
    }
    return std::string(prefix) + base64url(view::stb::deflate(text));
}

bool looks_like_share_code(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && text.substr(first).starts_with(family);
}

SharedCode decode_share_code(std::string_view given) {
    const std::string text = without_space(given);
    if (!text.starts_with(family) || text.find('.') == std::string::npos) {
        throw InputError(place + ": expected a line that begins with '" + std::string(prefix) + "', found " +
                         (text.empty() ? "nothing" : "'" + text.substr(0, 20) + "'"));
    }
    if (!text.starts_with(prefix)) {
        throw InputError(place + ": expected one of version 1, found '" +
                         text.substr(0, std::min<std::size_t>(text.find('.'), 20)) +
                         "', which another version of Ball Pit reads");
    }
    const auto packed = parse_base64url(std::string_view(text).substr(prefix.size()));
    const auto content = packed ? view::stb::inflate(*packed, most_json) : std::nullopt;
    if (!content) {
        throw InputError(place + ": expected a whole line, found one that is cut off or damaged");
    }
    return from_json(parse_json(*content, place));
}

}  // namespace ballpit::app
