// Brute force beside the grid: a second simulation of the same scene on a second backend of the same kind, which
// starts from the same bytes and takes the same steps, forth and back.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/window_session.h"
#include "core/stepper.h"
#include "measure/ball_probe.h"
#include "ui/probe.h"
#include "view/overlay.h"

namespace ballpit::app {

/// Most balls that brute force is offered for: n² pairs in one dispatch must not outlast a driver's patience, nor the
/// audience's where one thread computes them.
std::uint32_t most_brute_force_balls(std::string_view backend_name);

/// Why brute force is refused, in a sentence; nothing if it may run.
std::optional<std::string> brute_force_refusal(std::uint32_t balls, bool has_contacts, std::string_view backend_name);

class Split {
public:
    bool open() const { return simulation_ != nullptr; }
    void stop();

    /// Once a frame, after the session has run: opens if need be, and goes where the session is. Settings that change
    /// start it anew from the session's bytes. A sentence where brute force is refused; it is closed then. Throws what
    /// Simulation throws where the device has no room.
    std::optional<std::string> follow(Session& session);

    /// Copies its positions at this rate, or at once while nothing runs, and counts its contacts. `left`: the grid
    /// side's sample; null while there is none.
    void look(const measure::BufferSample* left, bool running, double now_s, double copies_a_second);

    Simulation& simulation() { return *simulation_; }
    /// Its contacts as lines.
    void add_to(view::Overlay& overlay, float top_overlap) const;
    /// `grid_pairs`: what the grid side finds and misses; null while it is not known.
    void describe(ui::ProbeState& state, const Session& session, const measure::FoundPairs* grid_pairs) const;

    /// Times of the session's own substeps, which the window takes.
    void add_grid_times(std::span<const StageTimes> times) { grid_time_.add(times); }

private:
    // Of a substep, over those that were timed in the last quarter of a second.
    class MeanTime {
    public:
        void add(std::span<const StageTimes> times);
        void refresh(double now_s);
        std::optional<double> ms() const { return ms_; }

    private:
        double sum_ms_ = 0.0;
        int substeps_ = 0;
        double shown_s_ = -1.0;
        std::optional<double> ms_;
    };

    void start(Session& session);
    void count(std::vector<vec4> positions, const Schedule& schedule);

    std::unique_ptr<Simulation> simulation_;
    std::unique_ptr<Stepper> stepper_;
    std::uint64_t layout_ = 0;            // of the session that this one copies
    std::uint64_t revision_ = 0;          // of the session, as far as this one has followed
    std::uint64_t counted_revision_ = 0;  // that was read while nothing ran; 0: none
    double asked_s_ = -1.0;
    measure::BufferSample sample_;
    measure::FoundPairs pairs_;
    bool counted_ = false;
    std::optional<double> apart_;
    MeanTime grid_time_;
    MeanTime brute_time_;
};

}  // namespace ballpit::app
