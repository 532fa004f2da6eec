#include "support/fuzz_case.h"

#include <algorithm>
#include <array>
#include <sstream>

#include "core/error.h"
#include "core/scene_file.h"
#include "core/scene_writer.h"
#include "core/stepper.h"
#include "core/text.h"

namespace ballpit::test {

namespace {

constexpr std::string_view start_of_about = "property fuzz: ";

std::string action_text(const FuzzAction& action) { return std::to_string(action.at) + " " + action.text; }

std::vector<std::string> parts_of(const std::string& text) {
    std::vector<std::string> parts;
    std::stringstream stream(text);
    for (std::string part; std::getline(stream, part, ';');) {
        parts.push_back(part.substr(std::min(part.find_first_not_of(' '), part.size())));
    }
    return parts;
}

}  // namespace

// "property fuzz: 12 substeps, seed 3; 4 set drag=1; 6 back step 1"
std::string case_text(const FuzzCase& fuzz_case) {
    Scene scene = fuzz_case.scene;
    scene.about = std::string(start_of_about) + std::to_string(fuzz_case.substeps) + " substeps, seed " +
                  std::to_string(fuzz_case.seed);
    for (const FuzzAction& action : fuzz_case.actions) {
        scene.about += "; " + action_text(action);
    }
    return scene_text(scene);
}

FuzzCase parse_case(std::string_view text, const std::string& file) {
    FuzzCase result;
    result.scene = parse_scene(text, file);
    const std::string& about = result.scene.about;
    std::string word;
    const std::vector<std::string> parts =
        about.starts_with(start_of_about) ? parts_of(about.substr(start_of_about.size())) : std::vector<std::string>();
    std::stringstream head(parts.empty() ? "" : parts.front());
    if (!(head >> result.substeps >> word >> word >> result.seed)) {
        throw InputError(file + ", /about: expected '" + std::string(start_of_about) + "N substeps, seed S', found '" +
                         about + "'");
    }
    for (std::size_t i = 1; i < parts.size(); ++i) {
        std::stringstream part(parts[i]);
        FuzzAction action;
        part >> action.at >> std::ws;
        std::getline(part, action.text);
        result.actions.push_back(action);
    }
    return result;
}

std::optional<Change> change_of(const FuzzAction& action, const Settings& settings) {
    std::stringstream stream(action.text);
    std::string kind;
    stream >> kind >> std::ws;
    if (kind == "set") {
        std::string setting;
        std::getline(stream, setting);
        Settings changed = settings;
        const std::size_t equals = setting.find('=');
        assign_setting(changed, setting.substr(0, equals),
                       equals == std::string::npos ? "" : setting.substr(equals + 1));
        return changed == settings ? std::nullopt : std::optional<Change>(changed);
    }
    if (kind == "add") {
        BallSpec ball;
        for (double* number : {&ball.position.x, &ball.position.y, &ball.position.z, &ball.velocity.x, &ball.velocity.y,
                               &ball.velocity.z, &ball.radius, &ball.mass}) {
            stream >> *number;
        }
        return AddBalls{{ball}};
    }
    return std::nullopt;
}

std::optional<Back> back_of(const FuzzAction& action) {
    std::stringstream stream(action.text);
    std::string kind;
    std::string unit;
    Back back;
    if (!(stream >> kind >> unit >> back.count) || kind != "back") {
        return std::nullopt;
    }
    back.unit = static_cast<std::uint8_t>(std::ranges::find(step_unit_names, unit) - step_unit_names.begin());
    return back;
}

}  // namespace ballpit::test
