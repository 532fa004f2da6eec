// What the panel for sharing and keeping shows, and the state hash that a class compares.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace ballpit::ui {

enum class HashMatch : std::uint8_t { unknown, equal, differs };

struct ReplayProgress {
    std::uint64_t step = 0;
    std::uint64_t of = 0;
};

struct ShareState {
    bool open = false;  // the panel
    std::string code;   // of the moment at which the panel was opened
    std::string note;   // what became of it
    std::string file;   // to save under, without a folder

    std::uint64_t hash_step = 0;  // steps done when the state had this hash
    std::optional<std::uint64_t> hash;
    HashMatch match = HashMatch::unknown;  // with the code that was opened last, at the step that it shows
    std::string match_about;

    std::optional<ReplayProgress> replay;  // on the way to what a code shows
};

}  // namespace ballpit::ui
