// Runs a simulation forth and back in any unit, down to a single dispatch. Back is a checkpoint and a replay: the
// same dispatches on the same bytes give the same bytes, and a hash a step proves it.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "core/simulation.h"
#include "core/timeline.h"

namespace ballpit {

enum class StepUnit : std::uint8_t { pass, stage, substep, step };
inline constexpr std::array<std::string_view, 4> step_unit_names = {"pass", "stage", "substep", "step"};

/// `dispatch` dispatches of the substep that starts at `moment` have run: fewer than its schedule has, because after
/// the last one the next moment has begun.
struct Position {
    Moment moment;
    std::uint32_t dispatch = 0;
    friend auto operator<=>(const Position&, const Position&) = default;
};

/// A replay that did not arrive at the bytes of the first run.
struct Divergence {
    std::uint64_t step = 0;
    std::optional<std::uint32_t> ball;  // the first one that differs, where the bytes of the first run are still there
};

class Stepper {
public:
    /// The timeline starts at the simulation's present moment. The simulation must outlive the stepper, and be run
    /// through it alone.
    Stepper(Simulation& simulation, std::size_t checkpoint_budget);

    /// After another scene, seed or backend: the timeline starts anew, here.
    void reset();
    /// Simulation::apply, remembered. Within a substep, the substep starts again after the change.
    void change(const Change& change);

    Position position() const { return {moment(), dispatch_}; }
    /// The substep as it is stepped through: sorted pass by pass, whatever the sort is that runs.
    const Schedule& schedule() { return schedule_of(simulation_.builds_grid()); }
    /// The same of any substep that builds its grid, or does not.
    const Schedule& schedule_of(bool builds_grid);
    /// The same of the substep that ended here, where one has since the timeline began or was gone along.
    const Schedule& schedule_behind() { return schedule_of(behind_built_grid_); }

    void forward(StepUnit unit);
    void back(StepUnit unit);  // at the start: nothing
    void to_step_start();
    void to_step_end();
    /// Any position that has been reached before, or lies ahead.
    void go_to(const Position& target);

    /// Runs dispatches [first, last) of schedule() in the backend's place, for whoever compares or counts while they
    /// run; whole substeps then go through it, too. Empty: the backend itself.
    using Runner =
        std::function<void(const Schedule&, const SubstepParams<double>&, std::size_t first, std::size_t last)>;
    void set_runner(Runner runner) { runner_ = std::move(runner); }

    /// Whether somebody looks at what a substep leaves in buffers other than the state's (at first: yes). If not, whole
    /// substeps run as is fastest. What the last one left is made up for when somebody begins to look, by running the
    /// steps since the checkpoint before it again; not where there is no room for checkpoints.
    void set_watched(bool watched);

    /// Takes the hashes that the device has ready and compares them with what is remembered.
    void update();
    const std::optional<Divergence>& divergence() const { return divergence_; }
    /// Hash of the state at the start of a step, once it is known.
    std::optional<std::uint64_t> hash(std::uint64_t step) const { return timeline_.hash(step); }

    const Timeline& timeline() const { return timeline_; }
    void set_budget(std::size_t bytes) { timeline_.set_budget(bytes); }

private:
    Moment moment() const { return {simulation_.step_count(), simulation_.substep_in_step()}; }
    std::uint32_t dispatches() { return static_cast<std::uint32_t>(schedule().dispatches.size()); }
    void run_dispatches(std::uint32_t last);
    void finish_substep();
    void arrive(std::uint64_t step_before, std::uint32_t substep_before);
    void restore(const Moment& moment);
    void run_to(const Moment& target);
    void remember();
    void locate_divergence(std::uint64_t step);
    std::optional<Moment> previous_moment(const Moment& now) const;
    std::uint32_t stage_end(std::uint32_t dispatch);
    std::uint32_t stage_start(std::uint32_t dispatch);

    Simulation& simulation_;
    Timeline timeline_;
    std::uint32_t dispatch_ = 0;
    Runner runner_;
    std::optional<Schedule> schedule_;  // made when it is asked for
    Schedule reused_schedule_;          // the same where the grid is used again
    bool behind_built_grid_ = true;
    bool watched_ = true;
    bool behind_kept_order_ = false;     // of the substep that ended here
    std::uint64_t schedule_change_ = 0;  // of the simulation, for which it was made
    std::uint64_t epoch_ = 0;            // tells hashes of a timeline that was left from those of this one
    std::optional<Divergence> divergence_;
};

}  // namespace ballpit
