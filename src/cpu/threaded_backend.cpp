#include "cpu/threaded_backend.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <utility>

#include "core/quarantine.h"
#include "cpu/assign_cells.h"
#include "cpu/collider.h"

namespace ballpit::cpu {

namespace {

constexpr unsigned most_threads = 16;
constexpr std::uint32_t share_size = 256;  // balls or slots: small enough that no thread is left with a dense corner

unsigned processors() { return std::clamp(std::thread::hardware_concurrency(), 1u, most_threads); }

std::uint32_t share_count(std::uint32_t balls) { return (balls + share_size - 1) / share_size; }

// Of a ball like this one somebody else would have to know, and the other ball of a pair does not see the same.
bool is_odd(const vec4& position, const vec4& velocity) {
    return in_quarantine(position) || !can_be_squared(vec3(position)) || !can_be_squared(vec3(velocity));
}

}  // namespace

ThreadedBackend::ThreadedBackend(unsigned threads) : workers_(threads == 0 ? processors() : threads) {}

std::string ThreadedBackend::device() const {
    return "CPU (float, " + std::to_string(workers_.threads()) + " threads; the mirror's bits)";
}

// Shares out the balls (or slots, of which there are as many); what each share counts is summed, in no order.
template <class Work>
void ThreadedBackend::share_out(const Dispatch& dispatch, const SubstepParams<float>& params, const Work& work) {
    const std::uint32_t shares = share_count(params.ball_count);
    statuses_.assign(shares, Status{});
    workers_.run(shares, [&](std::uint32_t share) {
        const std::uint32_t first = share * share_size;
        work(share, BallRange{first, std::min(first + share_size, params.ball_count)}, statuses_[share]);
    });
    if (dispatch.program.features.has(Feature::diagnostics)) {
        for (const Status& status : statuses_) {
            add_to_status(status);
        }
    }
}

void ThreadedBackend::run_in_whole(const Dispatch& dispatch, const SubstepParams<float>& params) {
    switch (dispatch.program.shader) {
        case Shader::assign_cells:
            return assign(dispatch, params);
        case Shader::bitonic_sort:
        case Shader::bitonic_sort_fused:
        case Shader::bitonic_sort_strides:
            return sort(params);
        case Shader::collide:
            return built_ ? collide_pairs(dispatch, params) : collide_each(dispatch, params);
        case Shader::clear_cells:
        case Shader::build_grid:
        case Shader::count_cells:
        case Shader::count_tiles:
        case Shader::scan_cells:
        case Shader::scatter_keys:
        case Shader::order_keys:
        case Shader::count_missed:
        case Shader::keep_places:
        case Shader::gather:
        case Shader::start_order:
        case Shader::put_back:
            return run_dispatch(dispatch, params);
    }
}

void ThreadedBackend::assign(const Dispatch& dispatch, const SubstepParams<float>& params) {
    const CollideInput<float> in = collide_input();
    share_out(dispatch, params, [&](std::uint32_t, BallRange balls, Status& status) {
        assign_cells<float>(params, in.positions, keys(), status, balls);
    });
    sorted_ = false;
    built_ = true;
}

// By counting. Keys come in the order of the balls and stay so within a cell, and no two keys are the same: there is
// one sorted list, whoever sorts.
void ThreadedBackend::sort(const SubstepParams<float>& params) {
    if (std::exchange(sorted_, true)) {
        return;
    }
    const std::span<Key> balls = keys().first(params.ball_count);
    unsorted_.assign(balls.begin(), balls.end());
    cell_ends_.assign(params.cell_count, 0);
    for (const Key& key : unsorted_) {
        ++cell_ends_[key.cell_id];
    }
    std::uint32_t end = 0;
    for (std::uint32_t& cell_end : cell_ends_) {
        cell_end = std::exchange(end, end + cell_end);  // where its first key goes
    }
    for (const Key& key : unsorted_) {
        balls[cell_ends_[key.cell_id]++] = key;
    }
}

// As the mirror does it, a range of balls each.
void ThreadedBackend::collide_each(const Dispatch& dispatch, const SubstepParams<float>& params) {
    const Features features = dispatch.program.features;
    const CollideInput<float> in = collide_input();
    const CollideOutput<float> out = collide_output(features);
    share_out(dispatch, params, [&](std::uint32_t, BallRange balls, Status& status) {
        collide<float>(params, features, in, out, status, balls);
    });
}

// A ball sums up its neighbours in the order of slots. So do the sums here: what a ball gets from those before it is
// added while those have their turn, one after another, and what it gets from those after it in its own turn. The force
// on the second ball of a pair is the first one's, with the other sign, to the last bit: every operation on the way is
// symmetric in the two.
void ThreadedBackend::collide_pairs(const Dispatch& dispatch, const SubstepParams<float>& params) {
    built_ = false;
    if (copy_sorted(dispatch, params)) {
        return collide_each(dispatch, params);
    }
    const Features features = dispatch.program.features;
    const CollideInput<float> in = collide_input();
    const CollideOutput<float> out = collide_output(features);
    find_forces(dispatch, params);
    sum_forces(params);
    share_out(dispatch, params, [&](std::uint32_t, BallRange balls, Status& status) {
        const Collider<float> collider{params, features, in, status};
        for (std::uint32_t id = balls.first; id < balls.end; ++id) {
            collider.advance(id, out, [this](const Ball<float>& ball) { return forces_[ball.id]; });
        }
    });
}

// Whether there is an odd one among them.
bool ThreadedBackend::copy_sorted(const Dispatch& dispatch, const SubstepParams<float>& params) {
    balls_.resize(params.ball_count);
    const bool unequal = dispatch.program.features.has(Feature::unequal_radii);
    const CollideInput<float> in = collide_input();
    std::atomic<bool> odd = false;
    share_out(dispatch, params, [&](std::uint32_t, BallRange slots, Status&) {
        bool odd_here = false;
        for (std::uint32_t slot = slots.first; slot < slots.end; ++slot) {
            const std::uint32_t ball = in.keys[slot].ball_id;
            const vec4& position = in.positions[ball];
            odd_here |= is_odd(position, in.velocities[ball]);
            balls_.put(slot, position, unequal ? position.w : params.radius);
        }
        if (odd_here) {
            odd = true;
        }
    });
    return odd;
}

void ThreadedBackend::find_forces(const Dispatch& dispatch, const SubstepParams<float>& params) {
    shares_.resize(share_count(params.ball_count));
    const CollideInput<float> in = collide_input();
    share_out(dispatch, params, [&](std::uint32_t number, BallRange slots, Status& status) {
        const Collider<float> collider{params, dispatch.program.features, in, status};
        Share& share = shares_[number];
        share.count = find_touching(params, in.keys, in.cell_ranges, balls_, slots.first, slots.end, share.pairs);
        share.forces.resize(std::max(share.forces.size(), share.count));
        for (std::size_t i = 0; i < share.count; ++i) {
            vec3 force(0);
            collider.add_pair(collider.ball(in.keys[share.pairs[i].first].ball_id, vec3(0)),
                              in.keys[share.pairs[i].second].ball_id, force);
            share.forces[i] = force;
        }
    });
}

void ThreadedBackend::sum_forces(const SubstepParams<float>& params) {
    forces_.assign(params.ball_count, vec3(0));
    const std::span<const Key> sorted = keys();
    for (const Share& share : shares_) {
        for (std::size_t i = 0; i < share.count; ++i) {
            forces_[sorted[share.pairs[i].first].ball_id] += share.forces[i];
            forces_[sorted[share.pairs[i].second].ball_id] -= share.forces[i];
        }
    }
}

}  // namespace ballpit::cpu
