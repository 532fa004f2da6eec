// Behind the views into grid, neighbours and buffers: says which copies they need, works out what follows from them,
// and gives panels and picture plain data. With everything closed it does nothing.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/background.h"
#include "app/probe_sample.h"
#include "app/probe_work.h"
#include "app/window_inspector.h"
#include "app/window_session.h"
#include "gl/buffer.h"
#include "ui/live_check.h"
#include "ui/probe.h"
#include "view/overlay.h"

namespace ballpit::app {

class Probe {
public:
    const ui::ProbeOptions& options() const { return options_; }
    void choose(const ui::ProbeOptions& options) { options_ = options; }
    void open_follow() { options_.follow = true; }
    void close_split() { options_.split = false; }
    void show_element(Slot slot, std::uint64_t element);
    void show_cell(std::uint32_t cell) { cell_jump_ = {cell, cell_jump_.serial + 1}; }
    std::optional<std::uint32_t> cell_of_ball(std::uint32_t ball) const;

    /// Whether keys and cells must be there before the first substep has run.
    bool needs_cells(ui::BallColour colour, bool ball_selected) const;
    /// Before Inspector::update().
    void want(Inspector& inspector, ui::BallColour colour, bool ball_selected) const;
    /// After it.
    void update(Session& session, const Inspector& inspector, const ui::Inspection& inspection, ui::BallColour colour,
                bool running);
    /// What the live check has found of the substep shown, for balls coloured by it. `revision`: of the buffers.
    void take_differences(const ui::LiveCheckState& check, std::uint32_t balls, std::uint64_t revision);

    /// Whether something is still being worked out or written.
    bool working() const { return background_.busy() || export_.busy(); }
    /// `grid`: of the simulation as it runs.
    void add_to(view::Overlay& overlay, const ui::Inspection& inspection, const Grid& grid) const;
    /// Float a ball for this colour, and the ends of its range; null while it is not there.
    const gl::Buffer* values(ui::BallColour colour) const;
    float value_low() const { return value_low_; }
    float value_high() const { return value_high_; }

    struct Setting {  // of the rest of the window, for legends
        ui::BallColour colour = ui::BallColour::tinted;
        bool occupancy = false;
        std::uint32_t top_count = 8;
        float top_speed = 10.0f;
    };
    void describe(ui::ProbeState& state, const Session& session, const ui::Inspection& inspection,
                  const Setting& setting);

    /// Writes the copy of a slot beside where the program was started, on a thread of its own.
    void start_export(Slot slot, const Inspector& inspector, const Session& session);
    /// A sentence for the screen: where the file is, or why it is not.
    std::string take_message();

    /// Of the substep that is shown; null while nothing is looked at, or no copy has arrived.
    const measure::BufferSample* sample() const { return sample_.get(); }
    float top_overlap() const;  // m: the end of the contacts' legend
    /// What the grid finds and misses; null while it is not known.
    const measure::FoundPairs* pairs() const { return pairs_known_ ? &work_.pairs : nullptr; }

private:
    ProbeWants wants(ui::BallColour colour) const;
    bool needs_sample(ui::BallColour colour, bool ball_selected) const;
    void take_sample(Session& session, const Inspector& inspector, bool running);
    void take_work(const ProbeWants& wants, bool running);
    void accept(ProbeWork work, std::shared_ptr<const measure::BufferSample> sample);
    void draw_lines();
    void set_values();
    void upload(std::span<const float> values);

    ui::ProbeOptions options_;
    ui::Jump buffer_jump_;
    ui::Jump cell_jump_;

    std::shared_ptr<const measure::BufferSample> sample_;
    std::uint64_t sample_revision_ = 0;
    bool within_substep_ = false;
    std::optional<measure::BallProbe> follow_;

    std::shared_ptr<const measure::BufferSample> work_sample_;  // that work_ is of
    ProbeWork work_;
    bool pairs_known_ = false;
    std::vector<view::LineSegment> lines_;  // of work_
    gl::Buffer value_buffer_;
    BallValue value_shown_ = BallValue::none;
    enum class Difference : std::uint8_t { not_checked, none, some };
    Difference difference_ = Difference::not_checked;
    std::uint64_t difference_revision_ = 0;
    float value_low_ = 0.0f;
    float value_high_ = 1.0f;
    struct Arrived {
        ProbeWork work;
        std::shared_ptr<const measure::BufferSample> sample;
    };
    Background<Arrived> background_;

    std::vector<ui::Legend> legends_;
    Background<std::string> export_;
    std::string message_;
};

}  // namespace ballpit::app
