#pragma once
// How far work is: what is done now, which share of the whole is done, and how long the rest may
// take. Programs, the editor and the library tell it in ways of their own.
#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "atlas/base/task_meter.h"

namespace burl {

/// A task that is expected, and about how many seconds it takes; 0: not known before it is under
/// way. What counts is how the tasks compare: all may take longer by the same factor.
struct ExpectedTask {
    std::string_view task{};
    double seconds = 0.0;
};

/// How far a round of tasks is, as estimates.
struct TimeLeft {
    std::optional<double> seconds{};  ///< of all rounds; none: not known yet
    double share = 0.0;               ///< of all rounds, 0 to 1; 0 where seconds are not known
};

/// The time left by the pace of the task under way and of the rounds before, and for the tasks
/// after it by what is expected of them, times how much longer than expected what is done has
/// taken. A task that comes several times is expected as often. One that is not among those
/// expected is unlike any.
TimeLeft time_left(const TaskMeter::Reading& reading, const std::vector<ExpectedTask>& expected);

/// Progress as it stands.
struct ProgressState {
    std::string item{};              ///< what is made, such as a file; may be empty
    std::size_t number = 0, of = 1;  ///< the item's number, from 0 on
    std::string task{};              ///< empty before the first
    std::size_t round = 0, rounds = 1;
    double share = 0.0;  ///< of all items, 0 to 1; never less than before
    std::optional<double> texels_per_second{}, seconds_left{};
    double seconds = 0.0;  ///< since the beginning
};

/// The course of work, which its threads write to. Any thread may read it at any time.
class Course {
  public:
    /// The meter that tasks write to.
    TaskMeter& meter() { return meter_; }
    /// Begins an item of several with its first task; `number` counts from 0.
    void begin_item(const std::string& name, std::size_t number, std::size_t of,
                    std::string_view task);
    /// Sets what is expected of the item's tasks, in their order.
    void expect(std::vector<ExpectedTask> tasks);
    /// The state now.
    ProgressState state();

  private:
    using Clock = TaskMeter::Clock;

    const Clock::time_point start_ = Clock::now();
    TaskMeter meter_;
    std::mutex mutex_;  ///< of all below
    std::string item_;
    std::size_t number_ = 0, of_ = 1;
    std::vector<ExpectedTask> expected_;
    double share_ = 0.0;
};

}  // namespace burl
