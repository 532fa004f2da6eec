// A running scene: settings, schedule, clock and the backend that computes it. Same scene, settings, seed and
// backend give the same states, bit for bit; nothing here knows the time of day.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <variant>
#include <vector>

#include "core/backend.h"
#include "core/scene.h"
#include "core/world.h"

namespace ballpit {

/// Where a running scene stands, apart from what its backend holds.
struct RunState {
    Settings settings;
    Box scene_box;
    WallShift walls;
    double largest_radius = 0.0;  // m
    Variety variety;
    double velocity_lag = 0.0;         // s, integrator.h
    std::vector<double> restitutions;  // a ball each, or empty
    std::uint32_t overlapping = 0;     // of the balls at the start
    std::uint32_t added = 0;           // balls beyond those of the scene
    std::uint64_t step_count = 0;      // whole steps since the start
    std::uint32_t substep = 0;         // substeps of the current step that have run
    std::uint32_t grid_age = 0;        // substeps that have used the grid; 0: the next one builds it
    std::uint64_t substeps_since_base = 0;
    double time_base = 0.0;  // s, when dt last changed
};

/// Everything that a running scene needs to go on from one moment, at the start of a substep. The balls' state stays on
/// the device that computed it.
struct Checkpoint {
    std::shared_ptr<const SavedState> state;
    RunState run;
};

/// Balls thrown in while the scene runs. SI units; their own restitution is not looked at.
struct AddBalls {
    std::vector<BallSpec> balls;
};

/// A substep as data: what would run, with which constants, and the restitutions that the device would hold.
struct Plan {
    Schedule schedule;
    SubstepParams<double> params;
    std::vector<double> restitutions;
};

/// Balls that overlap are pushed apart, by the springs alone in a thick medium, until the springs are slack or nothing
/// moves any more for want of room. Takes no time; every ball keeps its velocity.
struct Relax {};

/// What a user does to a running scene. All of it goes this way, so that it can be remembered and done again.
using Change = std::variant<Settings, AddBalls, Relax>;

class Simulation {
public:
    /// Throws InputError (count) or NoRoom.
    Simulation(Scene scene, const Settings& settings, std::uint64_t seed, std::unique_ptr<Backend> backend);

    /// Runs to the end of the current step: settings.substeps substeps, less those that have run.
    void step();
    /// `watched`: somebody will look at what its dispatches leave in the buffers, so it runs schedule(), else
    /// whole_schedule().
    void substep(bool watched = false);

    /// A substep in parts, for whoever looks between the dispatches: run [first, last) of schedule()
    /// with params(), then end. What the present substep runs: most have the same list, but where a grid is used more
    /// than once only every so many substeps build it.
    const Schedule& schedule() const { return builds_grid() ? schedule_ : reused_schedule_; }
    bool builds_grid() const { return run_.grid_age == 0; }
    SubstepParams<double> params() const;
    /// Whether the next substep takes no time: then nothing runs, nothing is counted, and no bit changes.
    bool still() const;
    void begin_substep();
    void end_substep() { end_substep(schedule()); }
    /// The same after another schedule has run: whole_schedule(), or one for a check.
    void end_substep(const Schedule& ran);
    /// What the present substep runs where nobody looks between its dispatches, nor at what they leave in other buffers
    /// than the state's; the same bits come of it.
    const Schedule& whole_schedule() const;

    /// Whether every substep is metered (meter.h); off, it costs nothing. Who runs a substep in parts begins it and
    /// ends it, or its reading is missing.
    void set_metering(bool on);
    bool metering() const { return metering_; }
    /// Meters the present moment, at the start of a substep, without waiting for that substep to run: at the price of
    /// one where balls touch each other.
    void meter();
    /// The records that have arrived, oldest first; never waits.
    std::vector<MeterRecord> take_records();

    /// The next substep of the present balls as it would be with other settings of the same count; nothing changes.
    Plan plan(const Settings& settings) const;

    /// At the start of a substep. What goes on from it builds its grid first, as every step and what follows a change
    /// do. The checkpoint belongs to this backend and scene.
    Checkpoint checkpoint();
    void restore(const Checkpoint& checkpoint);

    /// The same scene and settings from the start.
    void restart(std::uint64_t seed);
    /// Another scene on the same backend. On a throw the running scene is untouched, unless the device failed.
    void load(Scene scene, const Settings& settings, std::uint64_t seed);
    /// New settings while running. Balls that stay keep their motion; more balls come from the fill. Throws InputError
    /// or NoRoom; nothing has changed then.
    void change(const Settings& wanted);
    /// Throws InputError where there would be more than maximum_balls, NoRoom where the device cannot hold them;
    /// nothing has changed then.
    void add(const AddBalls& added);
    void relax();
    void apply(const Change& change);
    /// Moves the balls to another backend.
    void use(std::unique_ptr<Backend> backend);

    /// The state with velocities at the time of the positions. Waits for the device.
    BallState synchronised_state();
    /// The state as it is computed with: velocities may lag (integrator.h).
    BallState raw_state();

    const Scene& scene() const { return scene_; }
    const Settings& settings() const { return run_.settings; }
    Features features() const { return schedule_.features; }
    /// The box as it stands now.
    Box box() const { return shifted(run_.scene_box, run_.walls); }
    const Box& scene_box() const { return run_.scene_box; }
    /// Half the size of the smallest box around the origin that holds it.
    dvec3 half_extent() const { return box().half_extent(); }
    const WallShift& wall_shift() const { return run_.walls; }
    const Variety& variety() const { return run_.variety; }
    double largest_ball_radius() const { return run_.largest_radius; }  // m
    double velocity_lag() const { return run_.velocity_lag; }
    const std::vector<double>& restitutions() const { return run_.restitutions; }  // a ball each, or empty
    std::uint32_t added() const { return run_.added; }                             // balls beyond those of the scene
    /// Another number: another schedule.
    std::uint64_t schedule_changes() const { return schedule_changes_; }
    std::uint64_t seed() const { return seed_; }
    std::uint64_t step_count() const { return run_.step_count; }    // whole steps since the start
    std::uint32_t substep_in_step() const { return run_.substep; }  // substeps of the current step that have run
    std::uint32_t overlapping_at_start() const { return run_.overlapping; }
    /// s since the start, from integer counters; dt may have changed on the way.
    double time() const;
    Backend& backend() { return *backend_; }
    const Backend& backend() const { return *backend_; }

private:
    /// What throws leaves the run as it was.
    void all_or_nothing(const std::function<void()>& action);
    void change_now(const Settings& wanted);
    void add_now(const AddBalls& added);
    void request_reading();
    MeterReading run_round(const Settings& calm, const Schedule& schedule, const Variety& variety);
    void load_world(World world);
    void load_state(BallState state);
    void add_to_status(const Status& more);
    void load_backend(Backend& backend, BallState state) const;
    bool walls_move() const { return ballpit::walls_move(run_.walls, run_.settings, run_.scene_box, wall_room()); }
    Features wanted_features(const Settings& settings) const;
    /// `fastest`: the sort that stands for SortMethod::automatic.
    Schedule schedule_for(SortMethod fastest, std::uint32_t ball_count) const;
    void set_schedule(std::uint32_t ball_count);
    void derive_schedules();
    /// Where the settings leave the sort open: which one it is, by measurement, once for a number of balls.
    void choose_sort();
    double measured_build_ms(SortMethod sort);
    Walls walls(const Settings& settings) const;
    SubstepParams<double> params_for(const Settings& settings, const Schedule& schedule, const Variety& variety) const;
    void advance_walls();
    void age_grid();
    void rebase_clock();
    static double substep_dt(const Settings& settings) { return settings.dt / settings.substeps; }
    static double drag(const Settings& settings) { return settings.laws.drag ? settings.drag : 0.0; }
    double wall_room() const { return 2.0 * run_.largest_radius; }
    void interrupt_meters();
    void interrupt_meters(const Settings& wanted);
    /// The substep's dispatches with these constants, and what is to be seen of the result; then nothing has happened.
    void run_aside(const SubstepParams<double>& params, const std::function<void()>& look);

    Scene scene_;
    std::uint64_t seed_ = 0;
    std::unique_ptr<Backend> backend_;
    Schedule schedule_;
    Schedule reused_schedule_;
    Schedule kept_schedule_;  // the same with balls that stay in the order of their cells, where that can be
    Schedule kept_reused_schedule_;
    SortMethod fastest_sort_ = SortMethod::bitonic_fused;
    std::uint32_t sort_chosen_for_ = 0;  // balls
    std::uint64_t schedule_changes_ = 0;
    RunState run_;
    bool metering_ = false;
    bool metered_ = false;  // the present moment
    std::uint64_t meter_run_ = 0;
    MeterQueue meter_queue_;
};

}  // namespace ballpit
