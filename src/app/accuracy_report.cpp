#include "app/accuracy_report.h"

#include <array>
#include <ctime>
#include <sstream>

#include "core/text.h"
#include "measure/pareto.h"

namespace ballpit::app {

namespace {

using measure::Sweep;
using measure::SweepMetric;
using measure::SweepRow;

std::string now_text() {
    const std::time_t now = std::time(nullptr);
    std::array<char, 32> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&now));
    return text.data();
}

std::string_view precision_text(const SweepRow& row) { return row.point.compensated ? "compensated" : "float"; }

std::string_view integrator_text(Integrator integrator) {
    return integrator_names.at(static_cast<std::size_t>(integrator));
}

template <class T>
Json optional_json(const std::optional<T>& value) {
    return value ? Json(*value) : Json();
}

Json row_json(const SweepRow& row) {
    Json json = {{"integrator", integrator_text(row.point.integrator)},
                 {"substeps", row.point.substeps},
                 {"precision", precision_text(row)},
                 {"grid_reuse", row.point.grid_reuse},
                 {"cell_factor", row.cell_factor},
                 {"missed", optional_json(row.missed)},
                 {"substeps_a_contact", row.substeps_a_contact},
                 {"ms_a_second", row.ms_a_second},
                 {"ms_a_second_quartiles", {row.fast_ms_a_second, row.slow_ms_a_second}},
                 {"position_error", optional_json(row.position)},
                 {"energy_error", optional_json(row.energy)},
                 {"overlap", optional_json(row.overlap)},
                 {"restitution_error", optional_json(row.restitution)},
                 {"finite", row.finite}};
    if (!row.note.empty()) {
        json["note"] = row.note;
    }
    return json;
}

Json reference_json(const Sweep& sweep) {
    const measure::Reference& reference = sweep.reference();
    if (!reference.usable()) {
        return {{"note", reference.note.empty() ? "Broken off before the reference was done." : reference.note}};
    }
    const double dt = sweep.question().settings.dt;
    return {{"substeps", reference.substeps},
            {"substeps_a_contact", reference.substeps_a_contact},
            {"diameter", reference.diameter},
            {"horizon_s", static_cast<double>(*reference.steps) * dt},
            {"horizon_reached", *reference.steps + 1 < reference.twin_at.size()},
            {"twin_distance_at_horizon", reference.twin_at[*reference.steps]}};
}

// Rows of the front, by metric.
Json fronts_json(const Sweep& sweep) {
    Json fronts = Json::object();
    for (std::size_t metric = 0; metric < measure::sweep_metric_names.size(); ++metric) {
        std::vector<measure::Trade> trades;
        for (const SweepRow& row : sweep.rows()) {
            trades.push_back({row.ms_a_second, measure::metric_of(row, static_cast<SweepMetric>(metric))});
        }
        fronts[std::string(measure::sweep_metric_names[metric])] = measure::pareto_front(trades);
    }
    return fronts;
}

Json collision_json(const measure::CollisionRung& rung) {
    const measure::Spread& e = rung.group.restitution;
    return {{"integrator", integrator_text(rung.integrator)},
            {"substeps_a_contact", rung.substeps_a_contact},
            {"wall", rung.group.wall},
            {"exact", e.exact},
            {"expected", rung.expected},
            {"mean", e.mean},
            {"rounding", rung.rounding},
            {"deviation", e.deviation},
            {"worst", e.worst},
            {"error", e.error}};
}

std::string quoted(const std::string& text) {
    std::string quotes = "\"";
    for (const char c : text) {
        quotes += c == '"' ? "\"\"" : std::string(1, c);
    }
    return quotes + "\"";
}

template <class T>
std::string optional_text(const std::optional<T>& value) {
    return value ? shortest_text(static_cast<double>(*value)) : "";
}

}  // namespace

ReportOrigin report_origin(const Backend& backend, std::string command) {
    return {device_json(backend), std::move(command), now_text()};
}

Json accuracy_json(const Sweep& sweep, std::span<const measure::CollisionRung> collisions, const ReportOrigin& origin) {
    const measure::SweepQuestion& question = sweep.question();
    Json report = origin.device;
    report["command"] = origin.command;
    report["date"] = origin.date;
    report["scene"] = question.scene.name;
    report["balls"] = question.settings.balls;
    report["seed"] = question.seed;
    report["dt"] = question.settings.dt;
    report["seconds"] = static_cast<double>(sweep.steps()) * question.settings.dt;
    report["complete"] = sweep.done();
    report["float_floor"] = sweep.float_floor();
    report["reference"] = reference_json(sweep);
    report["rows"] = Json::array();
    for (const SweepRow& row : sweep.rows()) {
        report["rows"].push_back(row_json(row));
    }
    report["fronts"] = fronts_json(sweep);
    report["collisions"] = Json::array();
    for (const measure::CollisionRung& rung : collisions) {
        report["collisions"].push_back(collision_json(rung));
    }
    return report;
}

std::string accuracy_csv(const Sweep& sweep, const ReportOrigin& origin) {
    std::ostringstream out;
    out << "device,driver,backend,command,date,scene,balls,integrator,substeps,precision,grid_reuse,cell_factor,missed,"
           "substeps_a_contact,"
           "ms_a_second,q1,q3,position_error,energy_error,overlap,restitution_error,finite,note\n";
    for (const SweepRow& row : sweep.rows()) {
        for (const char* key : {"device", "driver", "backend"}) {
            out << quoted(origin.device[key].get<std::string>()) << ',';
        }
        out << quoted(origin.command) << ',' << origin.date << ',' << quoted(sweep.question().scene.name) << ','
            << sweep.question().settings.balls << ',' << integrator_text(row.point.integrator) << ','
            << row.point.substeps << ',' << precision_text(row) << ',' << row.point.grid_reuse << ','
            << shortest_text(row.cell_factor) << ',' << optional_text(row.missed) << ','
            << shortest_text(row.substeps_a_contact) << ',' << shortest_text(row.ms_a_second) << ','
            << shortest_text(row.fast_ms_a_second) << ',' << shortest_text(row.slow_ms_a_second) << ','
            << optional_text(row.position) << ',' << optional_text(row.energy) << ',' << optional_text(row.overlap)
            << ',' << optional_text(row.restitution) << ',' << (row.finite ? "true" : "false") << ','
            << quoted(row.note) << '\n';
    }
    return out.str();
}

}  // namespace ballpit::app
