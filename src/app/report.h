// Pieces that the reports of several commands share.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "app/atomic_file.h"
#include "core/extremes.h"
#include "core/layout.h"
#include "core/simulation.h"

namespace ballpit::app {

using Json = nlohmann::ordered_json;

/// backend, device, driver.
Json device_json(const Backend& backend);
/// Every setting that applies, as `--set` would take it.
Json settings_json(const Simulation& simulation);
/// One key a status bit, with the count.
/// `missed` is null where contacts may be missed and nobody counts them.
Json status_json(const Status& status, const Simulation& simulation);
/// One number for each of core/extremes.h under its key, counts as whole numbers; 0 where there is nothing to say.
Json extremes_json(const ExtremeNumbers& numbers);
/// 16 hexadecimal digits.
std::string hash_text(std::uint64_t hash);

/// A report on its way to a file (whole or not at all) or, for "-", to standard output. An empty place writes nothing.
class Report {
public:
    /// Opens the file now, so that a wrong place is told before the work and not after it. Throws InputError.
    explicit Report(const std::string& place);
    /// Throws InputError if the disk is full.
    void write(const std::string& text);

private:
    bool to_standard_output_;
    std::optional<AtomicFile> file_;
};

}  // namespace ballpit::app
