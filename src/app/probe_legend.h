// What the colours on screen mean, as the legend panels show it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "app/probe_work.h"
#include "ui/options.h"
#include "ui/probe.h"
#include "view/palette.h"

namespace ballpit::app {

struct LegendInput {
    ui::BallColour colour = ui::BallColour::tinted;
    ui::ProbeOptions options;
    const ProbeWork* work = nullptr;  // null where nothing is worked out
    bool following = false;
    bool occupancy = false;
    std::uint32_t top_count = 8;
    float top_speed = 10.0f;  // m/s
    float value_low = 0.0f;   // of worked out colours
    float value_high = 1.0f;
    float top_overlap = 0.0f;  // m
    bool checked = false;      // by the mirror
};

std::vector<ui::Legend> make_legends(const LegendInput& input);

}  // namespace ballpit::app
