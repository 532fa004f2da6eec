// A few threads that share out a loop. They wait between loops: awake for some microseconds, because the stages of a
// substep follow one another closely, then asleep. A loop never waits for a thread that has not taken a task: on a busy
// machine who calls does all of it.
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace ballpit::cpu {

class Workers {
public:
    using Task = std::function<void(std::uint32_t)>;

    /// `threads`: with the one that calls run(); at least 1.
    explicit Workers(unsigned threads);
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;
    ~Workers();

    unsigned threads() const { return static_cast<unsigned>(threads_.size()) + 1; }

    /// Calls task(0) to task(count - 1), each once, by whichever thread is free; comes back when all are done. The
    /// tasks must not write to what another one of them reads or writes. Throws what one of those that failed threw, if
    /// any.
    void run(std::uint32_t count, const Task& task);

private:
    void work();
    void take_tasks();
    void attempt(const Task& task, std::uint32_t number);
    std::uint32_t wait_for_round(std::uint32_t last) const;

    // The round in the upper half, its next task in the lower: who takes a task knows that its round still runs, and
    // with it what the next two members hold.
    std::atomic<std::uint64_t> ticket_ = 0;
    std::atomic<const Task*> task_ = nullptr;
    std::atomic<std::uint32_t> count_ = 0;
    std::atomic<std::uint32_t> done_ = 0;   // tasks of this round
    std::atomic<std::uint32_t> round_ = 0;  // one more for each loop that is shared
    std::atomic<bool> quit_ = false;
    std::mutex failure_lock_;
    std::exception_ptr failure_;
    std::vector<std::thread> threads_;
};

}  // namespace ballpit::cpu
