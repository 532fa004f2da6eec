// What `ballpit bench` says: a line a row for people, JSON and CSV for programs. A number that cannot be true is not
// printed as a result.
#pragma once

#include <ostream>
#include <span>
#include <string>

#include "app/accuracy_report.h"
#include "app/bench_run.h"

namespace ballpit::app {

Json limits_json(const measure::DeviceLimits& limits);
Json bench_row_json(const BenchRow& row, const measure::DeviceLimits& limits);

/// One row a row; an empty field where a number is impossible or was not asked for.
std::string bench_csv(std::span<const BenchRow> rows, const measure::DeviceLimits& limits, const ReportOrigin& origin);

void print_limits(std::ostream& out, const measure::DeviceLimits& limits);
void print_bench_header(std::ostream& out);
/// Beside each stage's time: what its bytes need at the least, in percent of it, at the rate of a copy.
void print_bench_row(std::ostream& out, const BenchRow& row, const measure::DeviceLimits& limits);

}  // namespace ballpit::app
