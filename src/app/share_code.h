// One line of text that holds a run and how it is looked at: whoever pastes it sees the same frame.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/view_json.h"
#include "core/stepper.h"

namespace ballpit::app {

/// Settings as --set takes them, key and value.
using SettingTexts = std::vector<std::pair<std::string, std::string>>;

/// What a user did at a moment: settings that were changed, balls that were thrown in, or overlaps that were relaxed.
struct SharedChange {
    Moment at;
    SettingTexts settings;
    std::vector<BallSpec> balls;
    bool relax = false;
};

struct SharedCode {
    std::string scene;              // name in the gallery; empty: the text below
    std::string scene_text;         // a scene from elsewhere, as a scene file
    std::uint64_t scene_check = 0;  // of the scene's text: whether both galleries mean the same by the name
    std::uint64_t seed = 0;
    SettingTexts start;  // that were not the scene's when the run began
    std::vector<SharedChange> changes;
    Moment substep;         // that is looked at
    std::uint32_t ran = 0;  // of its dispatches

    std::optional<std::uint64_t>
        hash;             // of the state at the start of the step; unknown where the code was asked for early
    std::string backend;  // that computed: "gpu", "cpu", or "both" where it changed on the way
    std::string device;

    Shown shown;
    std::optional<view::Camera> camera;
    std::optional<std::uint32_t> ball;  // selected
    std::optional<std::uint32_t> cell;
};

/// What must be assigned to come from one to the other.
SettingTexts setting_differences(const Settings& from, const Settings& to);
/// Throws InputError as assign_setting does.
void assign_settings(Settings& settings, const SettingTexts& texts);

/// The changes of a timeline up to a moment, as the differences that each of them made.
std::vector<SharedChange> shared_changes(const Settings& start, const std::vector<std::pair<Moment, Change>>& changes);

/// A number that is the same for the same scene.
std::uint64_t scene_check(const Scene& scene);

/// "ballpit1." and base64url of zlib of JSON.
std::string encode_share_code(const SharedCode& code);

/// White space around and within is no part of a code: mail programs break lines. Throws InputError in one sentence: no
/// code of ours, of another version, cut off or damaged, or a content that makes no sense.
SharedCode decode_share_code(std::string_view given);

/// Whether a text (such as the clipboard's) is meant as a share code.
bool looks_like_share_code(std::string_view text);

}  // namespace ballpit::app
