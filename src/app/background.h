// One piece of work at a time on a thread of its own, so that no frame waits for it.
#pragma once

#include <chrono>
#include <future>
#include <optional>
#include <utility>

namespace ballpit::app {

template <class Result>
class Background {
public:
    bool busy() const { return result_.valid(); }

    /// Not while busy. What the work needs it must own.
    template <class Work>
    void start(Work work) {
        result_ = std::async(std::launch::async, std::move(work));
    }

    /// The result, once it is there; throws what the work threw.
    std::optional<Result> take() {
        if (!result_.valid() || result_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
            return std::nullopt;
        }
        return result_.get();
    }

private:
    std::future<Result> result_;  // its destructor waits for the thread
};

}  // namespace ballpit::app
