// What is remembered of a run: checkpoints, changes, and a hash a step. Plain bookkeeping; the Stepper
// does the running.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/simulation.h"

namespace ballpit {

/// A moment between two substeps.
struct Moment {
    std::uint64_t step = 0;
    std::uint32_t substep = 0;
    friend auto operator<=>(const Moment&, const Moment&) = default;
};

/// What a checkpoint counts for beside the bytes of its state: device buffers are handed out in pages. A guess on the
/// high side, so that a scene of two balls does not keep millions of them.
inline constexpr std::size_t checkpoint_overhead = std::size_t{64} * 1024;

class Timeline {
public:
    /// Bytes that the checkpoints may take on the device. The first one and the newest three stay in any case.
    explicit Timeline(std::size_t budget) : budget_(budget) {}

    void clear();
    void set_budget(std::size_t bytes);
    std::size_t budget() const { return budget_; }
    std::size_t used_bytes() const { return used_; }
    std::size_t checkpoint_count() const { return checkpoints_.size(); }

    /// The first moment; there is one once a checkpoint was added.
    const Moment& start() const { return checkpoints_.begin()->first; }
    bool has(const Moment& moment) const { return checkpoints_.contains(moment); }
    /// Keeps a checkpoint; beyond the budget those go first whose neighbours lie close together for their age, so that
    /// the recent past is dense and the far past thin.
    void add(const Moment& moment, Checkpoint&& checkpoint);
    /// The newest checkpoint at or before the moment. There is one once the start was added.
    const std::pair<const Moment, Checkpoint>& at_or_before(const Moment& moment) const;

    /// A change takes hold at a moment, after those that did so before. The checkpoint of that moment and
    /// whatever was remembered of later ones no longer holds and is forgotten.
    void change(const Moment& moment, const Change& change);
    /// The changes that took hold exactly then, in order.
    std::span<const Change> changes_at(const Moment& moment) const;
    /// Every change up to here and beyond, by moment.
    const std::map<Moment, std::vector<Change>>& changes() const { return changes_; }

    /// How many substeps a step had that is over; 0 if that is not remembered.
    void record_substeps(std::uint64_t step, std::uint32_t substeps);
    std::uint32_t substeps_of(std::uint64_t step) const;

    /// The hash of the state on arriving at the start of a step. False: another hash was remembered for it.
    bool record_hash(std::uint64_t step, std::uint64_t hash);
    std::optional<std::uint64_t> hash(std::uint64_t step) const;

private:
    struct StepRecord {
        std::optional<std::uint64_t> hash;
        std::uint32_t substeps = 0;
    };

    StepRecord& record(std::uint64_t step);
    const StepRecord* find_record(std::uint64_t step) const;
    void shrink();

    std::size_t budget_;
    std::size_t used_ = 0;
    std::map<Moment, Checkpoint> checkpoints_;
    std::map<Moment, std::vector<Change>> changes_;
    std::optional<std::uint64_t> first_step_;  // of the first checkpoint: a saved moment may begin anywhere
    std::vector<StepRecord> steps_;            // from there on
};

}  // namespace ballpit
