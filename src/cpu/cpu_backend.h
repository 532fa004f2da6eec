// The mirror as a backend: walks the schedule with the mirror functions, on one thread.
// CpuBackend<float> is the mirror of the GPU, CpuBackend<double> the reference.
#pragma once

#include <vector>

#include "core/backend.h"
#include "cpu/collide.h"

namespace ballpit::cpu {

template <class Real>
class CpuBackend : public Backend {
public:
    std::string_view name() const override { return "cpu"; }
    std::string device() const override;
    std::string driver() const override;

    void load(const BallState& state, const Schedule& schedule, bool limit_force) override;
    void reschedule(const Schedule& schedule) override;
    void run(const Schedule& schedule, const SubstepParams<double>& params, std::size_t first,
             std::size_t last) override;
    void swap_states() override;
    std::unique_ptr<SavedState> save() override;
    void restore(const SavedState& state, const Schedule& schedule) override;
    void request_hash(std::uint64_t tag) override;
    std::vector<TaggedHash> take_hashes() override;
    void request_reading(std::uint64_t tag, const Schedule& schedule, const SubstepParams<double>& params,
                         const Synchronisation& synchronisation) override;
    std::vector<TaggedReading> take_readings() override;
    std::vector<double> take_reading_times() override;

    /// In the layout of layout.h: the reference's positions and velocities are rounded to float.
    Bytes read(Slot slot) override;
    void write(Slot slot, std::span<const std::byte> bytes) override;
    void request(Slot slot) override;
    std::optional<Bytes> poll(Slot slot) override;
    void start_history(std::uint32_t entries) override;
    void record_history() override;
    void request_history() override;
    std::optional<Bytes> poll_history() override;
    void set_timing(bool on) override { timing_ = on; }
    std::vector<StageTimes> take_times() override;
    void finish() override {}

    std::span<const Vec4<Real>> positions() const { return positions_; }
    std::span<const Vec4<Real>> velocities() const { return velocities_; }
    std::span<const Vec4<Real>> next_velocities() const { return next_velocities_; }
    std::span<const CellRange> cell_ranges() const { return cell_ranges_; }

protected:
    /// One dispatch of the schedule, as the shader does it.
    void run_dispatch(const Dispatch& dispatch, const SubstepParams<Real>& params);
    /// The same as a part of a whole substep, of which only the end can be seen.
    virtual void run_in_whole(const Dispatch& dispatch, const SubstepParams<Real>& params) {
        run_dispatch(dispatch, params);
    }

    CollideInput<Real> collide_input() const;
    CollideOutput<Real> collide_output(Features features);
    std::span<Key> keys() { return keys_; }
    void add_to_status(const Status& more) { status_ = sum_of(status_, more); }

private:
    void run_in_order(const Dispatch& dispatch, const SubstepParams<Real>& params);
    void collide_in_order(const Dispatch& dispatch, const SubstepParams<Real>& params, Status& status);
    std::span<Key> ball_keys() { return std::span(keys_).first(std::min(positions_.size(), keys_.size())); }
    Status& status_for(Features features) { return features.has(Feature::diagnostics) ? status_ : unwanted_; }
    void make_next(const Schedule& schedule);
    void load_left_out(std::span<const Compensation> compensations, const Schedule& schedule);

    std::vector<Vec4<Real>> positions_;
    std::vector<Vec4<Real>> velocities_;
    std::vector<Vec4<Real>> next_positions_;
    std::vector<Vec4<Real>> next_velocities_;
    std::vector<LeftOut<Real>> left_out_;
    std::vector<Real> damping_ratios_;
    std::vector<Key> keys_;
    std::vector<CellRange> cell_ranges_;
    std::vector<Vec4<Real>> built_positions_;
    std::vector<Vec4<Real>> sorted_positions_;
    std::vector<Vec4<Real>> sorted_velocities_;
    std::vector<std::uint32_t> used_tiles_;
    std::vector<std::uint32_t> tickets_;
    std::vector<Key> scattered_keys_;
    std::vector<std::uint32_t> tile_counts_;
    std::vector<std::uint32_t> origins_;
    Status status_{};
    Status unwanted_{};  // nobody looks at it without diagnostics
    std::array<std::optional<Bytes>, slot_count> requested_;
    std::vector<TaggedHash> hashes_;
    std::size_t history_limit_ = 0;  // bytes
    Bytes history_;
    std::optional<Bytes> requested_history_;
    std::vector<TaggedReading> readings_;
    std::vector<double> reading_times_;
    bool timing_ = false;
    std::vector<StageTimes> times_;
};

extern template class CpuBackend<float>;
extern template class CpuBackend<double>;

}  // namespace ballpit::cpu
