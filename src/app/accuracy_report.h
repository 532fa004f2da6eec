// The report of a sweep, as JSON and as CSV; of one that was broken off as well.
#pragma once

#include <span>
#include <string>

#include "app/report.h"
#include "measure/collision_ladder.h"
#include "measure/sweep.h"

namespace ballpit::app {

/// What a report says of where it comes from.
struct ReportOrigin {
    Json device;  // device_json
    std::string command;
    std::string date;  // 2026-01-31T12:00:00Z
};

/// Of now.
ReportOrigin report_origin(const Backend& backend, std::string command);

Json accuracy_json(const measure::Sweep& sweep, std::span<const measure::CollisionRung> collisions,
                   const ReportOrigin& origin);

/// One row a choice; an empty field where something was not measured.
std::string accuracy_csv(const measure::Sweep& sweep, const ReportOrigin& origin);

}  // namespace ballpit::app
