#pragma once
// Progress for people and programs, on stderr.
#include <array>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

#include "app/base/course.h"

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

/// "3 of 12, a.glb: synthesising the texture, 42 %, 12.4 Mtexel/s, 1 min 12 s left".
std::string progress_text(const ProgressState& state);
/// One object of JSON without line breaks.
std::string progress_json(const ProgressState& state);

/// Tells how far work is, from a thread of its own, until it is destroyed.
class Progress {
  public:
    explicit Progress(ProgressMode mode);
    /// Clears the line.
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// The course of the work; null where nobody is told.
    Course* course() { return mode_ == ProgressMode::none ? nullptr : &course_; }
    /// The meter of the course; null where nobody is told.
    TaskMeter* meter() { return mode_ == ProgressMode::none ? nullptr : &course_.meter(); }
    /// Begins an item of several with its first task; `number` counts from 0.
    void begin_item(const std::string& name, std::size_t number, std::size_t of,
                    std::string_view task) {
        course_.begin_item(name, number, of, task);
    }
    /// Begins round `round` of `rounds`, such as a frame, with its first task.
    void begin_round(std::size_t round, std::size_t rounds, std::string_view task) {
        course_.meter().begin_round(round, rounds);
        course_.meter().begin(task);
    }
    /// Tells that all is done, and nothing after it.
    void finish();

  private:
    void stop();
    void watch(const std::stop_token& stop);

    const ProgressMode mode_;
    const TaskMeter::Clock::time_point start_ = TaskMeter::Clock::now();
    Course course_;
    std::mutex mutex_;
    std::condition_variable_any changed_;  ///< wakes the thread to its end
    std::jthread thread_;                  ///< the last member: it ends before the others do
};

}  // namespace burl
