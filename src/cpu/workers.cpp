#include "cpu/workers.h"

#include <utility>

namespace ballpit::cpu {

namespace {

constexpr int looks_before_sleep = 4000;  // some tens of microseconds: less than waking up costs

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
        if (const std::uint32_t round = round_.load(std::memory_order_acquire); round != last) {
            return round;
        }
    }
    round_.wait(last, std::memory_order_acquire);
    return round_.load(std::memory_order_acquire);
}

void Workers::work() {
    std::uint32_t round = 0;
    while (true) {
        round = wait_for_round(round);
        if (quit_) {
            return;
        }
        take_tasks();
        working_.fetch_sub(1, std::memory_order_release);
    }
}

void Workers::take_tasks() {
    try {
        for (std::uint32_t i = next_.fetch_add(1); i < count_; i = next_.fetch_add(1)) {
            (*task_)(i);
        }
    } catch (...) {
        const std::lock_guard lock(failure_lock_);
        failure_ = failure_ ? failure_ : std::current_exception();
        next_ = count_;  // the others stop, too
    }
}

void Workers::run(std::uint32_t count, const std::function<void(std::uint32_t)>& task) {
    task_ = &task;
    count_ = count;
    next_ = 0;
    const bool shared = count > 1 && !threads_.empty();
    if (shared) {
        working_ = static_cast<std::uint32_t>(threads_.size());
        round_.fetch_add(1, std::memory_order_release);
        round_.notify_all();
    }
    take_tasks();
    for (int look = 0; shared && working_.load(std::memory_order_acquire) != 0; ++look) {
        if (look > looks_before_sleep) {
            std::this_thread::yield();  // another program has the processor that the last task needs
        }
    }
    if (failure_) {
        std::rethrow_exception(std::exchange(failure_, nullptr));
    }
}

}  // namespace ballpit::cpu
