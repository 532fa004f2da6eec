// A few threads that share out a loop. They wait between loops: awake for some microseconds, because the stages of a
// substep follow one another closely, then asleep.
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
    /// `threads`: with the one that calls run(); at least 1.
    explicit Workers(unsigned threads);
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;
    ~Workers();

    unsigned threads() const { return static_cast<unsigned>(threads_.size()) + 1; }

    /// Calls task(0) to task(count - 1), each once, by whichever thread is free; comes back when all are done. The
    /// tasks must not write to what another one of them reads or writes. Throws what the first task that failed threw.
    void run(std::uint32_t count, const std::function<void(std::uint32_t)>& task);

private:
    void work();
    void take_tasks();
    std::uint32_t wait_for_round(std::uint32_t last) const;

    const std::function<void(std::uint32_t)>* task_ = nullptr;
    std::uint32_t count_ = 0;
    std::atomic<std::uint32_t> next_ = 0;     // task to be taken
    std::atomic<std::uint32_t> round_ = 0;    // one more for each loop
    std::atomic<std::uint32_t> working_ = 0;  // threads that have not finished this round
    std::atomic<bool> quit_ = false;
    std::mutex failure_lock_;
    std::exception_ptr failure_;
    std::vector<std::thread> threads_;
};

}  // namespace ballpit::cpu
