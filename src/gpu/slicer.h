// How many slices a dispatch is cut into (core/dispatch_slices.h): by the number of pairs as far as it is known
// beforehand, and by the time that such dispatches were seen to take. Balls crowd together while they run, and nobody
// but the clock notices in time. Slices change no bit, so it does no harm that clocks differ from run to run.
#pragma once

#include "core/dispatch_slices.h"
#include "core/world.h"
#include "gl/timer.h"

namespace ballpit::gpu {

class Slicer {
public:
    /// Pairs that one slice may look at. Tests set other ones.
    void set_limit(double pairs) { limit_ = pairs; }

    /// The state that is loaded, and what it is going to run.
    void load(const BallState& state, const Schedule& schedule);

    /// Slices for a dispatch that looks at the pairs of so many cells; 1 where they are few.
    std::uint32_t slices(const Schedule& schedule, double cells = cells_around) const;

    /// Around a collide of `slices` slices (nothing takes longer), once in a while where it could be long.
    void begin(const Schedule& schedule);
    void end(std::uint32_t slices);

private:
    bool could_be_long(const Schedule& schedule) const;
    void look_at_time();

    double limit_ = pairs_a_slice;
    double density_ = 0.0;      // balls per m^3 around a ball, when they were loaded
    std::uint32_t slower_ = 1;  // slices for what was thought to need one
    std::uint32_t dispatches_ = 0;
    gl::SpanTimer timer_;
    bool timing_ = false;             // the dispatch that is under way
    std::uint32_t timed_slices_ = 0;  // of the one whose time has not arrived; 0: none
};

}  // namespace ballpit::gpu
