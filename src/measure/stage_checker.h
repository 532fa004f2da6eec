// Runs dispatches on a backend and on the mirror, on the same input, and compares what they write: names the first
// stage that differs.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/backend.h"
#include "measure/comparison.h"

namespace ballpit::measure {

/// What became of one slot that one stage writes, summed over all dispatches of that stage.
struct CheckRow {
    Stage stage{};
    Slot slot{};
    std::uint64_t elements = 0;
    std::uint64_t differing = 0;
    std::uint64_t beyond_bound = 0;
    std::uint64_t max_ulp = 0;
    double max_error = 0.0;
    double of_bound = 0.0;  // comparison.h
    std::string first;      // "substep 3, bitonic_sort k=8 j=2, slot 12: GPU (…), CPU (…)"
};

/// Both sides of a slot after the last dispatch that left a difference in it.
struct CheckedBytes {
    std::string dispatch;
    Bytes gpu;
    Bytes cpu;
    std::vector<std::uint32_t> differing;  // elements, ascending, the first thousand
};

class StageChecker {
public:
    StageChecker(Backend& backend, Backend& mirror) : backend_(backend), mirror_(&mirror) {}
    /// Without a mirror only the invariants are checked.
    explicit StageChecker(Backend& backend) : backend_(backend) {}

    /// The mirror takes the backend's state (`state`, as it is computed with) and status.
    void load(const BallState& state, const Schedule& schedule, bool limit_force);

    /// Runs dispatches [first, last) on both. After each one the mirror continues from the backend's bytes: a
    /// difference is reported where it arises, not where it ends up. After each stage its invariant is checked.
    void run(const Schedule& schedule, const SubstepParams<double>& params, std::size_t first, std::size_t last);

    /// The mirror follows the backend, which has changed roles where the schedule says so.
    void end_substep(const Schedule& schedule);

    /// Forgets the findings, not the state.
    void clear();

    const std::vector<CheckRow>& rows() const { return rows_; }  // in the order of the stages
    /// Nothing where the slot has not differed.
    const std::optional<CheckedBytes>& bytes(Slot slot) const { return bytes_[static_cast<std::size_t>(slot)]; }
    const std::vector<std::string>& violations() const { return violations_; }  // invariants broken, the first few
    std::uint64_t violation_count() const { return violation_count_; }
    /// The violation found last after this stage, if there is one.
    const std::optional<std::string>& violation(Stage stage) const {
        return stage_violations_[static_cast<std::size_t>(stage)];
    }
    std::uint64_t substeps() const { return substeps_; }
    std::uint64_t dispatches() const { return dispatches_; }

private:
    void compare(const Dispatch& dispatch, const SubstepParams<double>& params, const BallState& before);
    std::vector<double> bounds(Slot slot, const Dispatch& dispatch, const SubstepParams<double>& params,
                               const BallState& before);
    Bytes in_mirror_order(Slot slot, const Bytes& bytes);
    void add(CheckRow& row, const Comparison& difference, const Dispatch& dispatch) const;
    CheckRow& row_of(Stage stage, Slot slot);
    void check_invariant(const Schedule& schedule, const Dispatch& dispatch, const SubstepParams<double>& params,
                         const BallState& before);

    Backend& backend_;
    Backend* mirror_ = nullptr;
    std::vector<CheckRow> rows_;
    std::array<std::optional<CheckedBytes>, slot_count> bytes_;
    std::vector<std::string> violations_;
    std::array<std::optional<std::string>, stage_count> stage_violations_;
    std::uint64_t violation_count_ = 0;
    std::uint64_t substeps_ = 0;
    std::uint64_t dispatches_ = 0;
};

}  // namespace ballpit::measure
