// What the window says of the extremes: counts of the stages and of the clock, and what is to be warned of.
#pragma once

#include <array>

#include "app/clock.h"
#include "app/window_session.h"
#include "core/extremes.h"
#include "core/meter.h"

namespace ballpit::app {

class WindowExtremes {
public:
    /// `record`: of the meters, where they are open. Where the run stands at its start the overlaps are asked for,
    /// which waits for the device.
    void describe(Session& session, Clock& clock, const MeterRecord* record, ui::State& state);
    /// What is warned of now is not told again in this scene.
    void hide();

private:
    ExtremeNumbers shown_;
    std::array<bool, extreme_count> hidden_{};
    double stored_ = 0.0;                          // J, in overlaps at the start
    std::uint64_t looked_at_ = ~std::uint64_t{0};  // revision of the session
    int scene_changes_ = -1;
};

}  // namespace ballpit::app
