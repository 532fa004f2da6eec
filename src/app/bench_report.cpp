#include "app/bench_report.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

#include "measure/statistics.h"

namespace ballpit::app {

namespace {

using measure::DeviceLimits;
using measure::median;
using measure::quantile;

std::string fixed(double value, int digits) {
    std::ostringstream out;
    out << std::fixed << std::setprecision(digits) << value;
    return out.str();
}

Json quartiles_json(const Sample& sample) { return {quantile(sample, 0.25), quantile(sample, 0.75)}; }

// Null where it cannot be true.
Json possible_json(const Sample& sample, const std::string& why) { return why.empty() ? Json(median(sample)) : Json(); }

double stage_gb_s(const BenchRow& row, std::size_t stage) {
    return measure::gb_s(static_cast<std::size_t>(row.stage_bytes[stage]), median(row.stage_ms[stage]));
}

// How fast the device copies as much as this row's state.
double copy_of_state(const BenchRow& row, const DeviceLimits& limits) {
    return measure::copy_limit(limits, static_cast<std::size_t>(row.bytes_per_ball * row.balls));
}

// Of that rate, in percent.
double limit_share(const BenchRow& row, std::size_t stage, const DeviceLimits& limits) {
    const double limit = copy_of_state(row, limits);
    return limit > 0.0 ? 100.0 * stage_gb_s(row, stage) / limit : 0.0;
}

Json passes_json(const DrawnFrames& frames) {
    Json passes = Json::object();
    for (std::size_t pass = 0; pass < view::pass_count; ++pass) {
        passes[std::string(view::pass_names[pass])] = median(frames.pass_ms[pass]);
    }
    return passes;
}

Json frames_json(const DrawnFrames& frames) {
    return {{"ms", median(frames.frame_ms)},           {"ms_quartiles", quartiles_json(frames.frame_ms)},
            {"picture_ms", median(frames.picture_ms)}, {"picture_ms_quartiles", quartiles_json(frames.picture_ms)},
            {"passes", passes_json(frames)},           {"wall_ms", frames.wall_ms}};
}

Json settling_json(const Settling& settling) {
    return {{"at_rest", settling.at_rest},
            {"steps", settling.steps},
            {"seconds", settling.seconds},
            {"kinetic_over_weight_radius", settling.kinetic}};
}

Json impossible_json(const BenchRow& row) {
    Json json = Json::object();
    for (std::size_t stage = 0; stage < stage_count; ++stage) {
        if (!row.impossible[stage].empty()) {
            json[std::string(stage_names[stage])] = row.impossible[stage];
        }
    }
    if (!row.impossible_substep.empty()) {
        json["substep"] = row.impossible_substep;
    }
    for (const DispatchTime& dispatch : row.dispatches) {
        if (!dispatch.impossible.empty()) {
            json[dispatch.name] = dispatch.impossible;
        }
    }
    return json;
}

void put_sample(std::ostream& out, const Sample& sample, const std::string& why) {
    if (!sample.empty() && why.empty()) {
        out << median(sample);
    }
}

std::string quoted(const std::string& text) {
    std::string quoted = "\"";
    for (const char c : text) {
        quoted += c == '"' ? "\"\"" : std::string(1, c);
    }
    return quoted + "\"";
}

}  // namespace

Json limits_json(const DeviceLimits& limits) {
    Json copies = Json::array();
    for (const measure::CopyRate& copy : limits.copies) {
        copies.push_back({{"bytes", copy.bytes}, {"gb_s", copy.gb_s}});
    }
    return {{"clock_step_ms", limits.clock_step_ms}, {"least_span_ms", limits.least_span_ms}, {"copies", copies}};
}

Json bench_row_json(const BenchRow& row, const DeviceLimits& limits) {
    Json stages = Json::object();
    Json spread = Json::object();
    Json bytes = Json::object();
    Json shares = Json::object();
    const bool counted = row.stage_bytes[static_cast<std::size_t>(Stage::counting_sort)] != 0;
    const Stage other_sort = counted ? Stage::bitonic_sort : Stage::counting_sort;
    for (std::size_t stage = 0; stage < stage_count; ++stage) {
        if (static_cast<Stage>(stage) == other_sort) {
            continue;
        }
        const std::string name(stage_names[stage]);
        const std::string& why = row.impossible[stage];
        stages[name] = possible_json(row.stage_ms[stage], why);
        spread[name] = quartiles_json(row.stage_ms[stage]);
        bytes[name] = row.stage_bytes[stage];
        shares[name] = why.empty() ? Json(0.01 * limit_share(row, stage, limits)) : Json();
    }
    Json json = {{"backend", row.backend},
                 {"scene", row.scene},
                 {"state", row.state},
                 {"balls", row.balls},
                 {"substeps", row.substeps},
                 {"sort", row.sort},
                 {"grid_reuse", row.grid_reuse},
                 {"missed", row.missed},
                 {"ms_per_substep", possible_json(row.substep_ms, row.impossible_substep)},
                 {"ms_per_substep_quartiles", quartiles_json(row.substep_ms)},
                 {"wall_ms_per_substep", row.wall_ms},
                 {"steps", row.steps},
                 {"samples", row.substep_ms.size()},
                 {"lost_times", row.lost_times},
                 {"stages", stages},
                 {"stages_quartiles", spread},
                 {"stages_least_bytes", bytes},
                 {"stages_share_of_copy_rate", shares},
                 {"candidates_per_ball", row.crowding.candidates},
                 {"contacts_per_ball", row.crowding.contacts},
                 {"bytes_per_ball", row.bytes_per_ball},
                 {"cell_table_bytes", row.cell_table_bytes},
                 {"copy_gb_s", copy_of_state(row, limits)},
                 {"hash", hash_text(row.hash)}};
    if (row.settling) {
        json["settling"] = settling_json(*row.settling);
    }
    for (const auto& [name, sample, why] : row.dispatches) {
        json["dispatches"].push_back(
            {{"name", name}, {"ms", possible_json(sample, why)}, {"ms_quartiles", quartiles_json(sample)}});
    }
    if (row.frames) {
        json["frames"] = frames_json(*row.frames);
    }
    if (!row.possible()) {
        json["impossible"] = impossible_json(row);
    }
    return json;
}

std::string bench_csv(std::span<const BenchRow> rows, const DeviceLimits& limits, const ReportOrigin& origin) {
    std::ostringstream out;
    out << "device,driver,backend,scene,balls,substeps,sort,grid_reuse,missed,ms_per_substep,q1,q3,wall_ms_per_substep";
    for (const std::string_view name : stage_names) {
        out << ',' << name;
    }
    for (const std::string_view name : stage_names) {
        out << ',' << name << "_gb_s";
    }
    out << ",state,candidates,contacts,bytes_per_ball,cell_table_bytes,steps,frame_ms,picture_ms,wall_frame_ms,hash,"
           "impossible,copy_gb_s,least_span_ms,date,command,lost_times";
    for (const std::string_view name : view::pass_names) {
        out << ",picture_" << name << "_ms";
    }
    out << '\n';
    for (const BenchRow& row : rows) {
        out << origin.device["device"] << ',' << origin.device["driver"] << ',' << row.backend << ','
            << quoted(row.scene) << ',' << row.balls << ',' << row.substeps << ',' << row.sort << ',' << row.grid_reuse
            << ',' << row.missed << ',';
        put_sample(out, row.substep_ms, row.impossible_substep);
        out << ',' << quantile(row.substep_ms, 0.25) << ',' << quantile(row.substep_ms, 0.75) << ',' << row.wall_ms;
        for (std::size_t stage = 0; stage < stage_count; ++stage) {
            out << ',';
            put_sample(out, row.stage_ms[stage], row.impossible[stage]);
        }
        for (std::size_t stage = 0; stage < stage_count; ++stage) {
            out << ',';
            put_sample(out, {stage_gb_s(row, stage)}, row.impossible[stage]);
        }
        const DrawnFrames frames = row.frames.value_or(DrawnFrames{});
        out << ',' << row.state << ',' << row.crowding.candidates << ',' << row.crowding.contacts << ','
            << row.bytes_per_ball << ',' << row.cell_table_bytes << ',' << row.steps << ',';
        put_sample(out, frames.frame_ms, "");
        out << ',';
        put_sample(out, frames.picture_ms, "");
        out << ',';
        if (row.frames) {
            out << frames.wall_ms;
        }
        out << ',' << hash_text(row.hash) << ',' << quoted(row.possible() ? "" : impossible_json(row).dump()) << ','
            << copy_of_state(row, limits) << ',' << limits.least_span_ms << ',' << origin.date << ','
            << quoted(origin.command) << ',' << row.lost_times;
        for (const Sample& sample : frames.pass_ms) {
            out << ',';
            put_sample(out, sample, "");
        }
        out << '\n';
    }
    return out.str();
}

void print_limits(std::ostream& out, const DeviceLimits& limits) {
    out << "copies";
    for (const measure::CopyRate& copy : limits.copies) {
        out << (&copy == limits.copies.data() ? " " : ", ") << (copy.bytes >> 10) << " KiB at " << fixed(copy.gb_s, 0)
            << " GB/s";
    }
    out << "; the clock's step is " << limits.clock_step_ms * 1e6 << " ns, two looks at it are at least "
        << limits.least_span_ms * 1e6 << " ns apart\n";
}

void print_bench_header(std::ostream& out) {
    out << std::right << std::setw(8) << "balls" << std::setw(9) << "state" << std::setw(9) << "substeps"
        << std::setw(15) << "sort" << std::setw(11) << "ms/substep" << std::setw(18) << "quartiles" << std::setw(10)
        << "on wall";
    for (const std::string_view name : stage_names) {
        out << std::setw(15) << name;
    }
    out << std::setw(11) << "candidates" << std::setw(9) << "contacts" << std::setw(8) << "B/ball" << std::setw(12)
        << "cells B/ball"
        << "\n";
}

void print_bench_row(std::ostream& out, const BenchRow& row, const DeviceLimits& limits) {
    const auto balls = static_cast<double>(std::max(row.balls, 1u));
    out << std::right << std::setw(8) << row.balls << std::setw(9) << row.state << std::setw(9) << row.substeps
        << std::setw(15) << row.sort << std::setw(11)
        << (row.impossible_substep.empty() ? fixed(median(row.substep_ms), 4) : "impossible") << std::setw(18)
        << fixed(quantile(row.substep_ms, 0.25), 4) + ".." + fixed(quantile(row.substep_ms, 0.75), 4) << std::setw(10)
        << fixed(row.wall_ms, 4);
    for (std::size_t stage = 0; stage < stage_count; ++stage) {
        const std::string ms = fixed(median(row.stage_ms[stage]), 4);
        out << std::setw(15)
            << (row.impossible[stage].empty() ? ms + " " + fixed(limit_share(row, stage, limits), 0) + "%"
                                              : "impossible");
    }
    out << std::setw(11) << fixed(row.crowding.candidates, 1) << std::setw(9) << fixed(row.crowding.contacts, 2)
        << std::setw(8) << fixed(row.bytes_per_ball, 1) << std::setw(12)
        << fixed(static_cast<double>(row.cell_table_bytes) / balls, 1) << "\n";
    if (row.settling && !row.settling->at_rest) {
        out << "         not at rest after " << row.settling->steps << " steps in " << fixed(row.settling->seconds, 1)
            << " s: kinetic energy " << fixed(row.settling->kinetic, 3) << " of weight times radius\n";
    }
    if (row.frames) {
        out << "         drawn: " << fixed(median(row.frames->frame_ms), 3) << " ms a frame, of that "
            << fixed(median(row.frames->picture_ms), 3) << " ms for the picture; "
            << fixed(1000.0 / row.frames->wall_ms, 1) << " frames a second on the wall clock\n         passes:";
        for (std::size_t pass = 0; pass < view::pass_count; ++pass) {
            out << ' ' << view::pass_names[pass] << ' ' << fixed(median(row.frames->pass_ms[pass]), 3);
        }
        out << " ms\n";
    }
    for (const auto& [name, sample, why] : row.dispatches) {
        out << "         " << std::left << std::setw(34) << name << std::right << std::setw(10)
            << (why.empty() ? fixed(median(sample), 4) + " ms" : "impossible") << "\n";
    }
    if (row.lost_times > 0) {
        out << "         " << row.lost_times << " times are left out: the device's clock gave no result for them\n";
    }
    const Json impossible = impossible_json(row);
    for (const auto& [what, why] : impossible.items()) {
        out << "         impossible: " << what << ": " << why.get<std::string>() << "\n";
    }
    out << std::flush;
}

}  // namespace ballpit::app
