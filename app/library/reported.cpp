#include "app/library/reported.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

namespace burl::library {

namespace {

/// The longest time between two calls of a callback.
constexpr std::chrono::milliseconds longest_silence{50};
/// How often a new stage is looked for.
constexpr std::chrono::milliseconds shortest_silence{5};

/// The end of the work, which the calling thread waits for.
class End {
  public:
    void come(std::exception_ptr failure) {
        const std::lock_guard lock(mutex_);
        failure_ = std::move(failure), is_here_ = true;
        changed_.notify_one();
    }
    /// Waits for so long; whether the work has ended.
    bool wait(std::chrono::milliseconds time) {
        std::unique_lock lock(mutex_);
        return changed_.wait_for(lock, time, [&] { return is_here_; });
    }
    void rethrow() const {
        if (failure_) std::rethrow_exception(failure_);
    }

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    bool is_here_ = false;
    std::exception_ptr failure_;
};

void tell(const Progress& progress, const burl::ProgressState& state) {
    if (!progress({state.task, state.share, state.texels_per_second, state.seconds_left}))
        throw Error(ErrorKind::stopped, "stopped before it was done");
}

/// Tells of each new stage and every 50 ms until the work ends.
void tell_until(End& end, Course& course, const Progress& progress) {
    std::uint64_t stage = 0;
    for (auto told = std::chrono::steady_clock::now(); !end.wait(shortest_silence);) {
        const std::uint64_t number = course.meter().read().number;
        const auto now = std::chrono::steady_clock::now();
        if (number == stage && now - told < longest_silence) continue;
        stage = number, told = now;
        tell(progress, course.state());
    }
}

}  // namespace

void run_reported(const Progress& progress, const StoppableWork& work) {
    if (!progress) return work({}, nullptr);
    Course course;
    End end;
    std::exception_ptr told;
    {
        const std::jthread worker([&](const std::stop_token& stop) {
            try {
                work(stop, &course);
                end.come(nullptr);
            } catch (...) {
                end.come(std::current_exception());
            }
        });
        try {
            tell_until(end, course, progress);
        } catch (...) {
            told = std::current_exception();
        }
        // The worker's destructor requests a stop and joins.
    }
    if (told) std::rethrow_exception(told);
    end.rethrow();
    tell(progress, {.task = "done", .share = 1.0, .seconds_left = 0.0});
}

}  // namespace burl::library
