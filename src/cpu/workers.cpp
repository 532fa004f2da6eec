#include "cpu/workers.h"

#include <utility>

namespace ballpit::cpu {

namespace {

constexpr int looks_before_sleep = 4000;  // some tens of microseconds: less than waking up costs
constexpr int round_bits = 32;

}  // namespace

Workers::Workers(unsigned threads) {
    for (unsigned i = 1; i < threads; ++i) {
        threads_.emplace_back([this] { work(); });
    }
}

Workers::~Workers() {
    quit_ = true;
    ++round_;
    round_.notify_all();
    for (std::thread& thread : threads_) {
        thread.join();
    }
}

std::uint32_t Workers::wait_for_round(std::uint32_t last) const {
    for (int look = 0; look < looks_before_sleep; ++look) {
        if (const std::uint32_t round = round_; round != last) {
            return round;
        }
    }
    round_.wait(last);
    return round_;
}

void Workers::work() {
    std::uint32_t round = 0;
    while (true) {
        round = wait_for_round(round);
        if (quit_) {
            return;
        }
        take_tasks();
    }
}

void Workers::take_tasks() {
    std::uint64_t ticket = ticket_;
    while (true) {
        const Task* const task = task_;
        const auto number = static_cast<std::uint32_t>(ticket);
        if (number >= count_) {
            return;
        }
        if (ticket_.compare_exchange_weak(ticket, ticket + 1)) {
            attempt(*task, number);
            ++done_;
            ticket = ticket_;
        }
    }
}

void Workers::attempt(const Task& task, std::uint32_t number) {
    try {
        task(number);
    } catch (...) {
        const std::lock_guard lock(failure_lock_);
        failure_ = std::current_exception();
    }
}

void Workers::run(std::uint32_t count, const Task& task) {
    const std::uint64_t round = (ticket_ >> round_bits) + 1;
    count_ = 0;  // who comes late finds nothing to do
    task_ = &task;
    done_ = 0;
    ticket_ = round << round_bits;
    count_ = count;
    if (count > 1 && !threads_.empty()) {
        ++round_;
        round_.notify_all();
    }
    take_tasks();
    for (int look = 0; done_ != count; ++look) {
        if (look > looks_before_sleep) {
            std::this_thread::yield();  // another program has the processor that the last task needs
        }
    }
    if (failure_) {
        std::rethrow_exception(std::exchange(failure_, nullptr));
    }
}

}  // namespace ballpit::cpu
