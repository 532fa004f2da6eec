// Runs a case of the property fuzz and asks every property of it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/backend.h"
#include "support/fuzz_case.h"

namespace ballpit::test {

struct FuzzFailure {
    std::string property;  // its name: the shrinker keeps to it
    std::string what;
};

/// What was tried, so that nobody takes a fuzz for more than it is.
struct FuzzTally {
    std::uint64_t cases = 0;
    std::uint64_t substeps = 0;
    std::uint64_t changes = 0;      // that took hold
    std::uint64_t refused = 0;      // changes refused in one sentence
    std::uint64_t quarantined = 0;  // cases in which a ball was lost
    std::uint64_t energies = 0;     // cases whose energy had to stay bounded
    std::uint64_t stepped_back = 0;
};

struct FuzzBackends {
    std::function<std::unique_ptr<Backend>()> device;
    /// Where there is one, every dispatch is compared with it.
    std::function<std::unique_ptr<Backend>()> mirror;
    /// Where there is one: what the driver has complained of.
    std::function<std::optional<std::string>()> driver;
};

/// The first property that does not hold. Counts into the tally.
std::optional<FuzzFailure> run_fuzz_case(const FuzzCase& fuzz_case, const FuzzBackends& backends, FuzzTally& tally);

}  // namespace ballpit::test
