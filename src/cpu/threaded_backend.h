// The same bits as the mirror, sooner: a whole substep on all processors, with a counting sort, and each pair of balls
// looked at once. Who steps from dispatch to dispatch gets the mirror's own.
#pragma once

#include <vector>

#include "cpu/cpu_backend.h"
#include "cpu/touching.h"
#include "cpu/workers.h"

namespace ballpit::cpu {

class ThreadedBackend final : public CpuBackend<float> {
public:
    /// `threads`: 0 takes as many as there are processors, up to 16.
    explicit ThreadedBackend(unsigned threads = 0);

    std::string_view name() const override { return "threads"; }
    std::string device() const override;

private:
    // What a thread finds in its share of the slots.
    struct Share {
        std::vector<TouchingPair> pairs;
        std::vector<vec3> forces;  // N, of a pair on its first ball
        std::size_t count = 0;
    };

    void run_in_whole(const Dispatch& dispatch, const SubstepParams<float>& params) override;
    void assign(const Dispatch& dispatch, const SubstepParams<float>& params);
    void sort(const SubstepParams<float>& params);
    void collide_pairs(const Dispatch& dispatch, const SubstepParams<float>& params);
    void collide_each(const Dispatch& dispatch, const SubstepParams<float>& params);
    bool copy_sorted(const Dispatch& dispatch, const SubstepParams<float>& params);
    void find_forces(const Dispatch& dispatch, const SubstepParams<float>& params);
    void sum_forces(const SubstepParams<float>& params);
    template <class Work>
    void share_out(const Dispatch& dispatch, const SubstepParams<float>& params, const Work& work);

    Workers workers_;
    bool sorted_ = false;  // in this substep; the passes that follow find nothing to do
    bool built_ = false;   // in this substep: every ball looks into the cells around the one that it is in
    std::vector<std::uint32_t> cell_ends_;
    std::vector<Key> unsorted_;
    SortedBalls balls_;
    std::vector<Share> shares_;
    std::vector<Status> statuses_;  // of each share, so that no thread waits for another one
    std::vector<vec3> forces_;      // N, by ball
};

}  // namespace ballpit::cpu
