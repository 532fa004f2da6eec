// What the check of each stage found in the substep that is shown, and how a badge says it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/schedule.h"

namespace ballpit::ui {

enum class LiveCheckMode : std::uint8_t { off, invariants, mirror };
inline constexpr std::array<std::string_view, 3> live_check_names = {"off", "invariants", "mirror and invariants"};

/// A slot in which backend and mirror differed.
struct SlotDifference {
    Slot slot{};
    std::string_view dispatch;  // the last one that left a difference in it
    std::span<const std::byte> gpu;
    std::span<const std::byte> cpu;
    std::span<const std::uint32_t> differing;  // elements, ascending, the first thousand
};

struct StageCheck {
    bool ran = false;            // in the substep that is shown, under the check
    bool compared = false;       // with the mirror
    std::uint64_t elements = 0;  // of the slot that differs most, for each dispatch that wrote it
    std::uint64_t differing = 0;
    std::uint64_t beyond_bound = 0;  // of those, the ones that rounding does not explain
    std::uint64_t max_ulp = 0;
    double of_bound = 0.0;  // largest difference as a share of what rounding explains, of those within it
    std::string first;      // "bitonic_sort k=8 j=2, slot 12: GPU (…), CPU (…)"
    std::optional<std::string> violation;  // of the stage's invariant
    std::vector<SlotDifference> differences;
};

struct LiveCheckState {
    LiveCheckMode mode = LiveCheckMode::off;
    std::array<StageCheck, stage_count> stages;
    double ms = 0.0;               // what a substep under the check took
    bool mirror_computes = false;  // the CPU backend: nothing to compare with
    std::optional<Stage> shown;    // whose differences the table shows
};

struct Badge {
    enum class Kind : std::uint8_t { none, same, within, differs, not_judged };
    Kind kind = Kind::none;
    std::string text;    // "0 of 8 192 differ"
    std::string detail;  // a sentence: what first, what promise is broken
};

/// Red (differs) is what no rounding explains, or a broken invariant. After a red stage the invariants of later ones
/// are not judged: they stand on what it has left behind.
Badge stage_badge(const LiveCheckState& state, Stage stage);

/// What each stage promises, in two or three words.
std::string_view stage_promise(Stage stage);

}  // namespace ballpit::ui
