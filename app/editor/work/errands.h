#pragma once
// Work for later beside an editor's pictures, one after the other on a thread of its own: what may
// take long and nobody waits for.
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>

namespace burl {

/// All functions may be called by any thread, but end() by one other than its own.
class EditErrands {
  public:
    /// Returns early once `stop` is asked for. It must not throw.
    using Errand = std::function<void(const std::stop_token& stop)>;

    EditErrands();
    EditErrands(const EditErrands&) = delete;
    EditErrands& operator=(const EditErrands&) = delete;
    ~EditErrands() { end(); }

    void add(Errand errand);
    /// Stops what is under way, without waiting for that, and drops the rest.
    void cancel();
    /// The same, waits for it, and does nothing any more.
    void end();
    /// While held, what has not begun waits.
    void hold(bool held);
    bool idle() const;
    /// Waits until idle().
    void wait() const;

  private:
    void run(const std::stop_token& ending);

    mutable std::mutex mutex_;
    mutable std::condition_variable_any changed_;
    std::deque<Errand> waiting_;
    std::stop_source current_{std::nostopstate};
    bool busy_ = false, ended_ = false, held_ = false;
    std::jthread thread_;  ///< last: it sees all the others
};

}  // namespace burl
