#include "app/report.h"

#include <array>
#include <cstdio>
#include <iostream>

#include "app/atomic_file.h"

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

Json status_json(const Status& status) {
    return {{"not_finite", status.not_finite},
            {"out_of_bounds", status.out_of_bounds},
            {"over_capacity", status.over_capacity}};
}

std::string hash_text(std::uint64_t hash) {
    std::array<char, 17> text{};
    std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(hash));
    return text.data();
}

void write_report(const std::string& place, const std::string& text) {
    if (place.empty()) {
        return;
    }
    if (place == "-") {
        std::cout << text << std::flush;
        return;
    }
    AtomicFile file(place);
    file.stream() << text;
    file.commit();
}

}  // namespace ballpit::app
