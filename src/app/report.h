// Pieces that the reports of several commands share.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/layout.h"
#include "core/simulation.h"

namespace ballpit::app {

using Json = nlohmann::ordered_json;

/// backend, device, driver.
Json device_json(const Backend& backend);
/// Every setting that applies, as `--set` would take it.
Json settings_json(const Simulation& simulation);
/// One key a status bit, with the count.
Json status_json(const Status& status);
/// 16 hexadecimal digits.
std::string hash_text(std::uint64_t hash);
/// Writes to a file (whole or not at all) or, for "-", to standard output. An empty place writes nothing.
void write_report(const std::string& place, const std::string& text);

}  // namespace ballpit::app
