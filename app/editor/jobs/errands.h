#pragma once
// A background job queue beside the editor's baking: jobs that may take long and that no window
// waits for run one after the other on a thread of their own.
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>

namespace burl {

/// A first-in, first-out job queue with one thread. All functions may be called by any thread,
/// except that end() must not be called by a job.
class EditErrands {
  public:
    /// A job; it should return early once `stop` is requested, and must not throw.
    using Errand = std::function<void(const std::stop_token& stop)>;

    EditErrands();
    EditErrands(const EditErrands&) = delete;
    EditErrands& operator=(const EditErrands&) = delete;
    ~EditErrands() { end(); }

    /// Appends a job; after end() the job is dropped.
    void add(Errand errand);
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
    std::deque<Errand> waiting_;
    std::stop_source current_{std::nostopstate};
    bool busy_ = false, ended_ = false, held_ = false;
    std::jthread thread_;  ///< last member: its thread uses all the others
};

}  // namespace burl
