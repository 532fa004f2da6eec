// What the window of meters shows.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "measure/energy_balance.h"
#include "measure/stability.h"

namespace ballpit::ui {

struct MetersState {
    std::optional<MeterRecord> record;         // the newest that has arrived
    std::optional<measure::Balance> balance;   // at that record
    std::span<const measure::Balance> series;  // since its base
    std::vector<measure::Gauge> gauges;
    std::optional<double> ms;  // that a reading takes, median of the last
};

}  // namespace ballpit::ui
