// What the views need to know beyond the copies themselves, worked out on the CPU, on whatever thread.
#pragma once

#include <cstdint>
#include <vector>

#include "measure/ball_probe.h"
#include "measure/cell_table.h"

namespace ballpit::app {

enum class BallValue : std::uint8_t { none, slot, contacts, radius };

struct ProbeWants {
    bool pairs = false;
    bool cells = false;
    measure::CellOrder order;
    BallValue value = BallValue::none;

    bool any() const { return pairs || cells || value != BallValue::none; }
    friend bool operator==(const ProbeWants&, const ProbeWants&) = default;
};

struct ProbeWork {
    ProbeWants wants;
    measure::FoundPairs pairs;
    float largest_overlap = 0.0f;      // m, of the pairs found
    float usual_overlap = 0.0f;        // m: nine of ten are no larger
    std::vector<std::uint32_t> cells;  // rows of the table
    std::vector<float> values;         // one a ball
    double ms = 0.0;                   // what it cost
};

ProbeWork work_out(const measure::BufferSample& sample, const ProbeWants& wants);

}  // namespace ballpit::app
