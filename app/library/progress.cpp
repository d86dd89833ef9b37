#include "app/library/progress.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

#include "app/library/guard.h"

namespace burl::library {

namespace {

/// The longest time between two calls of a callback.
constexpr std::chrono::milliseconds longest_silence{50};

/// How far the work is, shared by the two threads.
class Course {
  public:
    void reach(const char* stage, double share) {
        const std::lock_guard lock(mutex_);
        stage_ = stage, share_ = share, is_new_ = true;
        changed_.notify_one();
    }
    void end(std::exception_ptr failure) {
        const std::lock_guard lock(mutex_);
        failure_ = std::move(failure), is_done_ = true;
        changed_.notify_one();
    }
    /// Waits for news; false once the work has ended. `tell` is called without the lock.
    bool wait(const Progress& progress) {
        std::unique_lock lock(mutex_);
        changed_.wait_for(lock, longest_silence, [&] { return is_new_ || is_done_; });
        if (is_done_) return false;
        is_new_ = false;
        const char* const stage = stage_;
        const double share = share_;
        lock.unlock();
        if (stage && !progress(stage, share)) throw stopped();
        return true;
    }
    void rethrow() const {
        if (failure_) std::rethrow_exception(failure_);
    }

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    const char* stage_ = nullptr;
    double share_ = 0.0;
    bool is_new_ = false, is_done_ = false;
    std::exception_ptr failure_;
};

}  // namespace

Error stopped() {
    return {ErrorKind::stopped, "the bake was stopped before it was done"};
}

void run_reported(const Progress& progress, const StoppableWork& work) {
    if (!progress) return work({}, [](const char*, double) {});
    Course course;
    std::exception_ptr told;
    {
        std::jthread worker([&](const std::stop_token& stop) {
            try {
                work(stop, [&](const char* stage, double share) {
                    if (stop.stop_requested()) throw stopped();
                    course.reach(stage, share);
                });
                course.end(nullptr);
            } catch (...) {
                course.end(std::current_exception());
            }
        });
        try {
            while (course.wait(progress)) {
            }
        } catch (...) {
            told = std::current_exception();
        }
        // The worker's destructor requests a stop and joins.
    }
    if (told) std::rethrow_exception(told);
    course.rethrow();
    progress("done", 1.0);
}

}  // namespace burl::library
