// What happens at the ends of every slider: cases as data, which `ballpit extremes` runs on any backend. A row says
// what was put in, what was found, what was counted and warned of, and whether all of it is as it must be.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/backend.h"

namespace ballpit::measure {

class ExtremeTrial;

/// One row of the table.
struct ExtremeCase {
    std::string_view id;     // "E1"
    std::string_view input;  // what is done, one line
    std::string_view right;  // what must come of it, one line
    void (*run)(ExtremeTrial&);
};

/// Every case that needs no window, in the order of the table.
std::span<const ExtremeCase> extreme_cases();

/// What was found, with its numbers.
struct ExtremeClaim {
    bool holds = false;
    std::string text;
};

/// A counter or a warning that was not zero.
struct ExtremeSign {
    std::string key;
    double number = 0.0;
    friend bool operator==(const ExtremeSign&, const ExtremeSign&) = default;
};

struct ExtremeRow {
    std::string id;
    std::string input;
    std::string right;
    std::vector<ExtremeClaim> claims;
    std::vector<ExtremeSign> signs;
    double seconds = 0.0;  // of the wall clock

    /// Without any claim nothing was shown.
    bool passed() const;
    /// "a; b", those that do not hold first and marked.
    std::string found() const;
    /// "not_finite 3, out_of_bounds 12" or "".
    std::string warned() const;
};

/// Makes the backends under test, one for each simulation of a case.
using MakeBackend = std::function<std::unique_ptr<Backend>()>;

/// What a case throws (but for running out of memory) is a claim that does not hold.
ExtremeRow run_extreme(const ExtremeCase& extreme, const MakeBackend& make_backend);

}  // namespace ballpit::measure
