// Measures one row of `ballpit bench`: the same steps several times from the same state, each time with other marks
// between them, because a mark costs time itself.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/drawn_buffers.h"
#include "app/paths.h"
#include "app/settle.h"
#include "core/simulation.h"
#include "gl/framebuffer.h"
#include "measure/crowding.h"
#include "measure/device_limits.h"
#include "view/passes.h"
#include "view/renderer.h"

namespace ballpit::app {

/// ms of some runs of the same.
using Sample = std::vector<double>;

struct DispatchTime {
    std::string name;
    Sample ms;
    std::string impossible;  // why that cannot be true; empty where it can
};

struct DrawnFrames {
    Sample frame_ms;                               // all substeps and the picture
    Sample picture_ms;                             // of that, the picture
    std::array<Sample, view::pass_count> pass_ms;  // of pictures that are marked within, hence a little slower
    double wall_ms = 0.0;                          // a frame, on the wall clock, queueing included
};

struct BenchRow {
    std::string backend;
    std::string scene;
    std::string state;  // start, settled
    std::optional<Settling> settling;
    measure::Crowding crowding;  // of the state that it begins with
    std::uint32_t balls = 0;
    std::uint32_t substeps = 0;
    std::string sort;
    std::uint32_t grid_reuse = 1;
    std::uint64_t steps = 0;   // timed
    std::uint32_t missed = 0;  // ends of contacts that a used grid did not show
    double bytes_per_ball = 0.0;
    std::size_t cell_table_bytes = 0;
    std::array<double, stage_count> stage_bytes{};    // that a substep moves at the least, on average
    Sample substep_ms;                                // a sample a step: its substeps' mean, no mark within
    std::array<Sample, stage_count> stage_ms;         // a sample a substep; a step where not each builds a grid
    double wall_ms = 0.0;                             // a substep, on the wall clock, queueing included
    double stages_wall_ms = 0.0;                      // all samples of the stages together, on the wall clock
    std::vector<DispatchTime> dispatches;             // on request
    double dispatches_wall_ms = 0.0;                  // all samples of theirs together
    std::size_t lost_times = 0;                       // to which the device's clock gave no result (gl::SpanTimer)
    std::optional<DrawnFrames> frames;                // on request
    std::uint64_t hash = 0;                           // of the state in the end: the same for every sort
    std::array<std::string, stage_count> impossible;  // why a stage's number cannot be true; empty where it can
    std::string impossible_substep;

    bool possible() const;
};

/// Draws the frames that are measured.
class BenchPicture {
public:
    /// Needs a current context. Throws as Screenshot does.
    BenchPicture(const Paths& paths, view::Look look, int width, int height);
    void draw(Simulation& simulation, const view::PassMark& mark = {});

private:
    view::Look look_;
    view::Renderer renderer_;
    gl::Framebuffer framebuffer_;
    DrawnBuffers buffers_;
};

struct BenchPlan {
    std::uint64_t steps = 20;  // to time, at most
    double limit_s = 20.0;     // of the wall clock, for a row: fewer steps where they would take longer
    bool dispatches = false;   // time each of them, too
    BenchPicture* picture = nullptr;
};

/// Begins at the checkpoint, with these settings of the same count.
BenchRow measure_row(Simulation& simulation, const Checkpoint& start, const Settings& settings, const BenchPlan& plan,
                     const measure::DeviceLimits& limits);

}  // namespace ballpit::app
