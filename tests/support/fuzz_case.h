// A case of the property fuzz: a scene, and what is done to it while it runs. Everything in it can be written into a
// scene file and read back; `about` then has what is done.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/simulation.h"

namespace ballpit::test {

/// Before substep `at` (counted from the start of the run).
struct FuzzAction {
    std::uint32_t at = 0;
    /// "set KEY=VALUE", "add X Y Z VX VY VZ RADIUS MASS", or "back PASS|STAGE|SUBSTEP|STEP COUNT", in lower case.
    std::string text;
    friend bool operator==(const FuzzAction&, const FuzzAction&) = default;
};

struct FuzzCase {
    Scene scene;
    std::uint64_t seed = 1;  // of the fill
    std::uint32_t substeps = 1;
    std::vector<FuzzAction> actions;  // in the order of `at`
};

/// A pure function of both numbers. Whatever a scene file may hold is possible, extremes included; most cases are dense
/// enough for balls to meet.
FuzzCase make_fuzz_case(std::uint64_t seed, std::uint64_t number);

/// As a scene file. What is done, and for how many substeps, stands in `about`.
std::string case_text(const FuzzCase& fuzz_case);
/// Throws InputError as parse_scene does, and where `about` is not of a case.
FuzzCase parse_case(std::string_view text, const std::string& file);

/// What the action does, as the simulation takes it; nothing for going back, and for what is so already. Throws
/// InputError for a setting that does not parse.
std::optional<Change> change_of(const FuzzAction& action, const Settings& settings);
/// How far back, in which unit; nothing for changes.
struct Back {
    std::uint8_t unit = 0;  // StepUnit
    std::uint32_t count = 0;
};
std::optional<Back> back_of(const FuzzAction& action);

}  // namespace ballpit::test
