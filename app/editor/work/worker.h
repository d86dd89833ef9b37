#pragma once
// Work beside the user interface: the latest request wins, and refining an older one is told to
// stop.
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

#include "app/recipe/recipe.h"

namespace burl {

/// A recipe to be shown; while its slider still moves a rough picture is enough.
struct WorkerRequest {
    Recipe recipe{};
    bool moving = false;
    std::uint64_t number = 0;  ///< the caller's own
};

/// Runs `work` on a thread of its own. All functions may be called by one other thread.
class EditWorker {
  public:
    /// Makes what is asked for, and hands it over to whom is its own affair; returns early once
    /// `stop` is asked for. What it throws is kept for take_problem().
    using Work = std::function<void(const WorkerRequest&, const std::stop_token& stop)>;
    /// `wake` is called by the worker's thread at the end of every request.
    EditWorker(Work work, std::function<void()> wake);
    EditWorker(const EditWorker&) = delete;
    EditWorker& operator=(const EditWorker&) = delete;
    /// Stops what is under way and waits for it.
    ~EditWorker();

    /// From now on this counts: one that waits is dropped and one under way told to stop, but for
    /// one of a moving slider, whose rough picture comes first. (A slider moves more often than
    /// pictures take: nobody would see any.)
    void request(WorkerRequest request);
    /// What was asked for last counts once more, unless it still waits; for any thread.
    void again();
    /// Nothing is under way or waits.
    bool idle() const;
    /// Waits until idle().
    void wait() const;
    /// Why the last request failed, once.
    std::optional<std::string> take_problem();

  private:
    void run(const std::stop_token& ending);
    void attempt(const WorkerRequest& request, const std::stop_token& stop);

    Work work_;
    std::function<void()> wake_;
    mutable std::mutex mutex_;
    mutable std::condition_variable_any changed_;
    std::optional<WorkerRequest> waiting_, last_;
    std::stop_source current_{std::nostopstate};
    bool busy_ = false, moving_ = false;  ///< what is under way
    std::optional<std::string> problem_;
    std::jthread thread_;  ///< last: it sees all the others
};

}  // namespace burl
