#include "app/run_meters.h"

#include "measure/stability.h"

namespace ballpit::app {

namespace {

Json vector_json(const dvec3& v) { return {v.x, v.y, v.z}; }

Json reading_json(const MeterRecord& record) {
    const MeterReading& r = record.reading;
    return {{"step", record.step},
            {"time_s", record.time},
            {"kinetic_J", r.kinetic},
            {"potential_J", r.potential},
            {"elastic_J", r.elastic},
            {"drag_heat_W", record.drag_heat()},
            {"contact_heat_W", r.contact_heat},
            {"wall_heat_W", r.wall_heat},
            {"wall_work_W", r.wall_work},
            {"hand_work_W", r.hand_work},
            {"momentum_kg_m_s", vector_json(r.momentum)},
            {"angular_momentum_kg_m2_s", vector_json(r.angular_momentum)},
            {"max_overlap_m", r.max_overlap},
            {"max_overlap_share", r.max_overlap_share},
            {"mean_overlap_share", r.mean_overlap_share()},
            {"contacts_of_balls", 0.5 * r.contact_ends},
            {"contacts_with_walls", r.wall_contacts},
            {"fastest_m_s", r.max_speed},
            {"floor_force_N", r.floor_force},
            {"weight_N", record.weight()}};
}

Json balance_json(const measure::Balance& b) {
    return {{"since_s", b.base_time},
            {"start_J", b.start},
            {"kinetic_J", b.kinetic},
            {"potential_change_J", b.potential},
            {"elastic_J", b.elastic},
            {"heat_drag_J", b.drag_heat},
            {"heat_contacts_J", b.contact_heat},
            {"heat_walls_J", b.wall_heat},
            {"work_J", b.work},
            {"unexplained_J", b.unexplained()}};
}

Json gauge_json(const measure::Gauge& gauge) {
    Json json{{"name", gauge.name},   {"value", gauge.value},
              {"unit", gauge.unit},   {"light", measure::light_names[static_cast<std::size_t>(gauge.light())]},
              {"amber", gauge.amber}, {"red", gauge.red},
              {"text", gauge.text}};
    if (gauge.remedy) {
        json["remedy"] = gauge.remedy->key + "=" + gauge.remedy->value;
    }
    return json;
}

}  // namespace

void RunMeters::take(Simulation& simulation) {
    for (const MeterRecord& record : simulation.take_records()) {
        balance_.add(record);
    }
    simulation.backend().take_reading_times();
}

void RunMeters::read_now(Simulation& simulation) {
    simulation.meter();
    while (!balance_.balance() || record().step != simulation.step_count() ||
           record().substep != simulation.substep_in_step()) {
        simulation.backend().finish();
        take(simulation);
    }
}

Json meters_json(const RunMeters& meters, const Simulation& simulation, bool metered) {
    Json json{{"reading", reading_json(meters.record())}};
    if (metered) {
        json["balance"] = balance_json(meters.balance());
    }
    json["gauges"] = Json::array();
    for (const measure::Gauge& gauge : measure::gauges(meters.record(), simulation)) {
        json["gauges"].push_back(gauge_json(gauge));
    }
    return json;
}

}  // namespace ballpit::app
