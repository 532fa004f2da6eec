#include "app/report.h"

#include <array>
#include <cstdio>
#include <iostream>

namespace ballpit::app {

Json device_json(const Backend& backend) {
    return {{"backend", std::string(backend.name())}, {"device", backend.device()}, {"driver", backend.driver()}};
}

Json settings_json(const Simulation& simulation) {
    Json json = Json::object();
    for (const SettingInfo& info : setting_table()) {
        if (setting_applies(info, simulation.settings().laws)) {
            json[std::string(info.key)] = setting_text(info, simulation.settings());
        }
    }
    return json;
}

Json status_json(const Status& status, const Simulation& simulation) {
    const Schedule& schedule = simulation.schedule();
    const bool unknown = schedule.key_count > 0 && simulation.settings().grid_reuse > 1 && !schedule.keeps_places;
    return {{"not_finite", status.not_finite},
            {"out_of_bounds", status.out_of_bounds},
            {"over_capacity", status.over_capacity},
            {"missed", unknown ? Json() : Json(status.missed)}};
}

Json extremes_json(const ExtremeNumbers& numbers) {
    Json json = Json::object();
    for (const ExtremeInfo& info : extreme_table()) {
        const double number = numbers[info.extreme];
        json[std::string(info.key)] = info.counted ? Json(static_cast<std::uint64_t>(number)) : Json(number);
    }
    return json;
}

std::string hash_text(std::uint64_t hash) {
    std::array<char, 17> text{};
    std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(hash));
    return text.data();
}

Report::Report(const std::string& place) : to_standard_output_(place == "-") {
    if (!place.empty() && !to_standard_output_) {
        file_.emplace(place);
    }
}

void Report::write(const std::string& text) {
    if (to_standard_output_) {
        std::cout << text << std::flush;
    } else if (file_) {
        file_->stream() << text;
        file_->commit();
    }
}

}  // namespace ballpit::app
