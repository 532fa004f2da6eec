// What the present settings make of single collisions, measured: the scene's own programs run 256 collisions, each by
// itself, on a backend of their own: {two balls, ball and wall} x {typical speed, largest speed} x 64 phases of the
// substep in which the contact begins. Beside each measured value stands the exact one of this spring and dashpot.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/backend.h"
#include "measure/probe_collisions.h"

namespace ballpit::measure {

/// One quantity over the phases.
struct Spread {
    double exact = 0.0;
    double mean = 0.0;
    double deviation = 0.0;  // standard deviation
    double worst = 0.0;      // the value farthest from the exact one
    double error = 0.0;      // 95 % of the phases are nearer to the exact value than this
};

/// The collisions of one kind.
struct ProbeGroup {
    bool wall = false;
    bool largest = false;  // at the largest speed
    double speed = 0.0;    // m/s, of approach
    Spread restitution;
    Spread overlap;              // largest overlap, in diameters
    Spread duration;             // s, while the force acts
    Spread gain;                 // kinetic energy after / before, less that of the exact restitution
    std::uint32_t unending = 0;  // collisions that never began or never ended

    /// Too fast for the spring: nearly all of the diameter would be overlap, and the balls come out on the other side.
    bool passes_through() const { return !wall && overlap.exact >= 0.9; }
};

struct ProbeResult {
    std::string nothing;              // why there is nothing to probe; else empty
    std::vector<ProbeGroup> groups;   // pairs first, typical speed first
    double substeps_a_contact = 0.0;  // Nc of two of the lightest balls (of ball and wall where balls do not touch)
    std::uint32_t substeps = 0;       // that were run

    /// Over all groups that do not pass through each other: the largest error of 95 % of the phases; restitution as a
    /// share of the approach speed.
    double restitution_error() const;
    /// The same of the largest overlap, in diameters.
    double overlap_error() const;
    /// The largest exact overlap, in diameters: beyond 1 balls pass through each other.
    double softness() const;
    std::uint32_t unending() const;
};

class CollisionProbe {
public:
    /// Loads its balls into `backend`, which belongs to the probe until it is done and outlives it. Throws what
    /// Backend::load throws.
    CollisionProbe(Backend& backend, const ProbeQuestion& question);

    /// Runs up to so many substeps, or sees whether the device has sent what they left; never waits. True once the
    /// result is there.
    bool advance(std::uint32_t substeps);
    bool done() const { return done_; }
    std::uint32_t substeps_run() const { return ran_; }
    std::uint32_t substeps_to_run() const { return collisions_.substeps; }
    const ProbeResult& result() const { return result_; }

private:
    // What is remembered of a collision from one piece of the history to the next: nothing grows with its length.
    struct Track {
        double velocity = 0.0;  // m/s, of separation
        double overlap = 0.0;   // m, of the last substep
        double largest_overlap = 0.0;
        std::uint32_t pushed = 0;  // substeps in which the velocity changed
    };

    void run(std::uint32_t substeps);
    void follow(const Bytes& history);
    void finish();
    ProbeGroup summary(std::size_t group) const;

    Backend& backend_;
    ProbeQuestion question_;
    ProbeCollisions collisions_;
    std::vector<Track> tracks_;
    double velocity_lag_ = 0.0;
    std::uint32_t ran_ = 0;
    std::uint32_t recorded_ = 0;
    bool waiting_ = false;
    bool done_ = false;
    ProbeResult result_;
};

/// The whole probe at once; waits for the device.
ProbeResult run_probe(Backend& backend, const ProbeQuestion& question);

}  // namespace ballpit::measure
