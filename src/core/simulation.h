// A running scene: settings, schedule, clock and the backend that computes it. Same scene, settings, seed and
// backend give the same states, bit for bit; nothing here knows the time of day.
#pragma once

#include <cstdint>
#include <memory>

#include "core/backend.h"
#include "core/scene.h"
#include "core/world.h"

namespace ballpit {

/// Everything that a running scene needs to go on from one moment, at the start of a substep. The state itself stays
/// on the device that computed it.
struct Checkpoint {
    std::shared_ptr<const SavedState> state;
    Settings settings;
    dvec3 half_extent{0.0};
    double largest_radius = 0.0;
    double velocity_lag = 0.0;
    std::vector<float> restitutions;
    std::uint32_t overlapping = 0;
    std::uint64_t step_count = 0;
    std::uint32_t substep = 0;
    std::uint64_t substeps_since_base = 0;
    double time_base = 0.0;
};

class Simulation {
public:
    /// Throws InputError (count) or DeviceError (room).
    Simulation(Scene scene, const Settings& settings, std::uint64_t seed, std::unique_ptr<Backend> backend);

    /// Runs to the end of the current step: settings.substeps substeps, less those that have run.
    void step();
    void substep();

    /// A substep in parts, for whoever looks between the dispatches: run [first, last) of schedule()
    /// with params(), then end.
    const Schedule& schedule() const { return schedule_; }
    SubstepParams<double> params() const;
    void end_substep();

    /// At the start of a substep. The checkpoint belongs to this backend and scene.
    Checkpoint checkpoint();
    void restore(const Checkpoint& checkpoint);

    /// The same scene and settings from the start.
    void restart(std::uint64_t seed);
    /// Another scene on the same backend. On a throw the running scene is untouched, unless the device failed.
    void load(Scene scene, const Settings& settings, std::uint64_t seed);
    /// New settings while running. Balls that stay keep their motion; more balls come from the fill.
    void change(const Settings& wanted);
    /// Moves the balls to another backend.
    void use(std::unique_ptr<Backend> backend);

    /// The state with velocities at the time of the positions. Waits for the device.
    BallState synchronised_state();
    /// The state as it is computed with: velocities may lag (integrator.h).
    BallState raw_state();

    const Scene& scene() const { return scene_; }
    const Settings& settings() const { return settings_; }
    Features features() const { return schedule_.features; }
    const dvec3& half_extent() const { return half_extent_; }
    std::uint64_t seed() const { return seed_; }
    std::uint64_t step_count() const { return step_count_; }    // whole steps since the start
    std::uint32_t substep_in_step() const { return substep_; }  // substeps of the current step that have run
    std::uint32_t overlapping_at_start() const { return overlapping_; }
    /// s since the start, from integer counters; dt may have changed on the way.
    double time() const;
    Backend& backend() { return *backend_; }
    const Backend& backend() const { return *backend_; }

private:
    void load_world(const World& world);
    void load_state(const BallState& state);
    Schedule wanted_schedule(std::uint32_t ball_count) const;
    void rebase_clock();
    double substep_dt() const { return settings_.dt / settings_.substeps; }
    double drag() const { return scene_.laws.drag ? settings_.drag : 0.0; }

    Scene scene_;
    Settings settings_;
    std::uint64_t seed_ = 0;
    std::unique_ptr<Backend> backend_;
    Schedule schedule_;
    dvec3 half_extent_{0.0};
    double largest_radius_ = 0.0;
    double velocity_lag_ = 0.0;
    std::vector<float> restitutions_;
    std::uint32_t overlapping_ = 0;
    std::uint64_t step_count_ = 0;
    std::uint32_t substep_ = 0;
    std::uint64_t substeps_since_base_ = 0;
    double time_base_ = 0.0;
};

}  // namespace ballpit
