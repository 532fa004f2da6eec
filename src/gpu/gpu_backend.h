// The GPU as a backend: owns the buffers and walks the schedule. Binds by slot, derives each barrier from the
// next use, labels every dispatch, and times stages with queries that are read late.
#pragma once

#include <filesystem>
#include <memory>

#include "core/backend.h"
#include "core/hazards.h"
#include "gl/buffer.h"
#include "gl/readback.h"
#include "gl/timer.h"
#include "gpu/meter.h"
#include "gpu/programs.h"
#include "gpu/slicer.h"
#include "gpu/state_hasher.h"
#include "gpu/state_history.h"

namespace ballpit::gpu {

class GpuBackend final : public Backend {
public:
    /// Needs a current GL 4.3 context for as long as it lives. Throws gl::Error if it is older.
    explicit GpuBackend(std::filesystem::path shader_folder);
    /// The same with programs that other backends of this context use, too.
    explicit GpuBackend(std::shared_ptr<Programs> programs);

    std::string_view name() const override { return "gpu"; }
    std::string device() const override;
    std::string driver() const override;

    /// Memory that this backend's own buffers take counts as free.
    StorageLimits storage_limits() const override;
    void load(const BallState& state, const Schedule& schedule, bool limit_force) override;
    void reschedule(const Schedule& schedule) override;
    void run(const Schedule& schedule, const SubstepParams<double>& params, std::size_t first,
             std::size_t last) override;
    void swap_states() override;
    bool keeps_order() const override { return true; }
    bool is_in_order() const override { return in_order_; }
    std::unique_ptr<SavedState> save() override;
    void restore(const SavedState& state, const Schedule& schedule) override;
    void request_hash(std::uint64_t tag) override;
    std::vector<TaggedHash> take_hashes() override { return hasher_.take(); }
    void request_reading(std::uint64_t tag, const Schedule& schedule, const SubstepParams<double>& params,
                         const Synchronisation& synchronisation) override;
    std::vector<TaggedReading> take_readings() override { return meter_.take(); }
    std::vector<double> take_reading_times() override { return meter_.take_times(); }
    Bytes read(Slot slot) override;
    void write(Slot slot, std::span<const std::byte> bytes) override;
    void request(Slot slot) override;
    std::optional<Bytes> poll(Slot slot) override;
    void start_history(std::uint32_t entries) override;
    void record_history() override;
    void request_history() override { history_.request(); }
    std::optional<Bytes> poll_history() override { return history_.poll(); }
    void set_timing(bool on) override { timing_ = on; }
    std::vector<StageTimes> take_times() override;
    void finish() override;

    /// The buffer in this slot, for use as a vertex attribute, buffer texture or storage to read: nothing is read back
    /// to draw.
    const gl::Buffer& buffer_for_drawing(Slot slot);
    /// Bytes of all buffers on the device.
    std::size_t allocated_bytes() const;
    /// How often glMemoryBarrier was called, since the backend was made.
    std::uint64_t barriers_issued() const { return barriers_issued_; }
    /// Pairs that one dispatch may look at before it is cut into slices; from the next substep on.
    void set_slice_limit(double pairs) { slicer_.set_limit(pairs); }
    /// How often glDispatchCompute was called for a schedule, since the backend was made.
    std::uint64_t dispatches_issued() const { return dispatches_issued_; }

private:
    // A slot names a role, a physical buffer plays it: collide's output becomes the input by a change of roles.
    std::size_t physical(Slot slot) const { return hazards_.physical(slot); }
    gl::Buffer& buffer(Slot slot) { return buffers_[physical(slot)]; }
    struct SlotRoom {
        Slot slot;
        std::size_t bytes;
    };
    /// Every slot, in the order of their numbers.
    static std::vector<SlotRoom> rooms_of(const Schedule& schedule);
    /// All of them, or NoRoom and nothing has changed.
    void make_room(std::span<const SlotRoom> rooms);
    void compile(const Schedule& schedule);
    void forget_grid(const Schedule& schedule);
    void begin_order(const Schedule& schedule);
    void bring_back();
    void look_at(Slot slot);
    void leave_order();
    void barrier(Uses uses);
    void use(Slot slot, Use use);
    void run_dispatch(const Dispatch& dispatch, const Schedule& schedule, const ShaderParams& params);
    void run_slices(const Dispatch& dispatch, const Schedule& schedule, Programs::Compiled& compiled);

    std::shared_ptr<Programs> programs_;
    std::array<gl::Buffer, slot_count> buffers_;
    std::array<std::size_t, slot_count> used_bytes_{};
    Hazards hazards_;
    bool in_order_ = false;        // next_* hold the present state, in the order of the keys
    bool in_place_of_ids_ = true;  // positions and velocities hold it, in the order of ball ids
    std::uint32_t balls_in_order_ = 0;
    std::uint64_t barriers_issued_ = 0;
    std::uint64_t dispatches_issued_ = 0;
    Slicer slicer_;
    std::array<gl::Readback, slot_count> readbacks_;
    StateHasher hasher_;
    StateHistory history_;
    Meter meter_;
    bool timing_ = false;
    gl::SpanTimer timer_;
};

}  // namespace ballpit::gpu
