#pragma once
// Progress for people and programs, on stderr: what is done now, which share of the whole is done,
// and how long the rest may take.
#include <array>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "atlas/base/task_meter.h"

namespace burl {

enum class ProgressMode : unsigned {
    automatic,  ///< `line` where stderr is a terminal, else `plain`
    line,       ///< one line, drawn anew ten times a second
    plain,      ///< a line of its own every ten seconds
    json,       ///< a line of JSON for every task, and two a second
    none
};

inline constexpr std::array<std::string_view, 5> progress_modes = {"auto", "line", "plain", "json",
                                                                   "none"};

/// The mode of a word of progress_modes, where `automatic` has become what it is here; `quiet`
/// makes that `none`.
ProgressMode progress_mode(std::string_view word, bool quiet);

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

/// "3 of 12, a.glb: synthesising the texture, 42 %, 12.4 Mtexel/s, 1 min 12 s left".
std::string progress_text(const ProgressState& state);
/// One object of JSON without line breaks.
std::string progress_json(const ProgressState& state);

/// Tells what a meter shows, from a thread of its own, until it is destroyed.
class Progress {
  public:
    explicit Progress(ProgressMode mode);
    /// Clears the line.
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// The meter that tasks write to; null where nobody is told.
    TaskMeter* meter() { return mode_ == ProgressMode::none ? nullptr : &meter_; }
    /// Begins an item of several with its first task; `number` counts from 0.
    void begin_item(const std::string& name, std::size_t number, std::size_t of,
                    std::string_view task);
    /// Sets what is expected of the item's tasks, in their order.
    void expect(std::vector<ExpectedTask> tasks);
    /// Tells that all is done, and nothing after it.
    void finish();

  private:
    using Clock = TaskMeter::Clock;
    ProgressState state();
    void stop();
    void watch(const std::stop_token& stop);

    const ProgressMode mode_;
    const Clock::time_point start_ = Clock::now();
    TaskMeter meter_;
    std::mutex mutex_;                     ///< of all below
    std::condition_variable_any changed_;  ///< wakes the thread to its end
    std::string item_;
    std::size_t number_ = 0, of_ = 1;
    std::vector<ExpectedTask> expected_;
    double share_ = 0.0;
    std::jthread thread_;  ///< the last member: it ends before the others do
};

}  // namespace burl
