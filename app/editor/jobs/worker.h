#pragma once
// Threads beside the user interface: a worker for which the latest request wins, and the work for
// an older one is told to stop; and a job queue for jobs that may take long and that no window
// waits for.
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

#include "app/editor/jobs/synthesis.h"
#include "app/recipe/recipe.h"

namespace burl {

/// A first-in, first-out job queue with one thread. All functions may be called by any thread,
/// except that end() must not be called by a job.
class JobQueue {
  public:
    /// A job; it should return early once `stop` is requested, and must not throw.
    using Job = std::function<void(const std::stop_token& stop)>;

    JobQueue();
    JobQueue(const JobQueue&) = delete;
    JobQueue& operator=(const JobQueue&) = delete;
    ~JobQueue() { end(); }

    /// Appends a job; after end() the job is dropped.
    void add(Job job);
    /// Requests the stop of the running job, without waiting for it, and drops the waiting jobs.
    void cancel();
    /// Requests the stop of the running job, drops the waiting ones, joins the thread and drops
    /// every job added later.
    void end();
    /// While held, no waiting job is started.
    void hold(bool held);
    /// Whether no job runs or waits.
    bool idle() const;
    /// Blocks until idle().
    void wait() const;

  private:
    void run(const std::stop_token& ending);

    // `mutex_` guards waiting_, current_, busy_, ended_ and held_; `changed_` is notified when they
    // change.
    mutable std::mutex mutex_;
    mutable std::condition_variable_any changed_;
    std::deque<Job> waiting_;
    std::stop_source current_{std::nostopstate};
    bool busy_ = false, ended_ = false, held_ = false;
    std::jthread thread_;  ///< last member: its thread uses all the others
};

/// A recipe to show; while its slider is `moving`, a coarse level is enough.
struct WorkerRequest {
    Recipe recipe{};
    bool moving = false;
    SynthesisWish synthesis{};
    std::uint64_t number = 0;  ///< the caller's number of the request
};

/// Runs `work` on a thread of its own, one request at a time. All functions may be called by one
/// other thread.
class EditWorker {
  public:
    /// Serves a request and publishes the result itself; should return early once `stop` is
    /// requested. The message of an exception is kept for take_problem().
    using Work = std::function<void(const WorkerRequest&, const std::stop_token& stop)>;
    /// `wake` is called by the worker's thread at the end of every request.
    EditWorker(Work work, std::function<void()> wake);
    EditWorker(const EditWorker&) = delete;
    EditWorker& operator=(const EditWorker&) = delete;
    /// Requests the stop of the running work and waits for its end.
    ~EditWorker();

    /// Replaces the waiting request and stops the work under way, unless that serves a moving
    /// slider: its coarse level is finished first. (A slider moves more often than a level takes,
    /// so otherwise none would ever be shown.)
    void request(WorkerRequest request);
    /// Serves the last request once more, unless a request is waiting. May be called by any thread.
    void again();
    /// Whether no request is being served or waits.
    bool idle() const;
    /// Blocks until idle().
    void wait() const;
    /// Returns and clears the message of the last failure.
    std::optional<std::string> take_problem();

  private:
    void run(const std::stop_token& ending);
    void attempt(const WorkerRequest& request, const std::stop_token& stop);

    Work work_;
    std::function<void()> wake_;
    // `mutex_` guards waiting_, last_, current_, busy_, moving_ and problem_; `changed_` is
    // notified when a request arrives or ends.
    mutable std::mutex mutex_;
    mutable std::condition_variable_any changed_;
    std::optional<WorkerRequest> waiting_, last_;  ///< the request waiting, and the one served last
    std::stop_source current_{std::nostopstate};
    bool busy_ = false, moving_ = false;  ///< whether work is under way, and for a moving slider
    std::optional<std::string> problem_;
    std::jthread thread_;  ///< last member: its thread uses all the others
};

}  // namespace burl
