// What the window of cost against the number of balls shows.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "measure/cost_curve.h"

namespace ballpit::ui {

struct CostLine {
    std::string sort;
    std::vector<measure::CostPoint> points;  // ascending
};

struct CostsState {
    std::vector<CostLine> lines;
    bool begun = false;  // since this window was first opened
    bool running = false;
    bool stale = false;    // another scene, or other settings, since it began
    bool possible = true;  // the scene can have other numbers of balls
    double progress = 0.0;
    std::string here_sort;  // the running scene's, and its balls
    double here_balls = 0.0;
};

}  // namespace ballpit::ui
