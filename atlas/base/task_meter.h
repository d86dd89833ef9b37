#pragma once
// What a program is doing and how much of it is done: written by the threads that work, read by one
// that tells a person.
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string_view>
#include <vector>

namespace burl {

/// The task under way: a name, a whole in units of the task's own (texels, bytes), and how many of
/// them are done. Tasks follow one another; threads that add to one must have ended before the next
/// begins. All of it may be read at any time.
class TaskMeter {
  public:
    using Clock = std::chrono::steady_clock;

    /// A task that counted what it did, and is over.
    struct Past {
        std::string_view task{};
        double seconds = 0.0;
    };

    struct Reading {
        std::string_view task{};  ///< empty before the first
        std::uint64_t total = 0;  ///< units of the task; 0: unknown
        std::uint64_t done = 0;
        bool counts_texels = false;
        double seconds = 0.0;               ///< since the task began
        std::size_t round = 0, rounds = 1;  ///< of a sequence, such as frames
        double round_seconds = 0.0;         ///< since the round began
        double earlier_seconds = 0.0;       ///< of the rounds before
        std::vector<Past> past{};           ///< of the round
        std::uint64_t number = 0;           ///< how many tasks have begun

        /// The share of the task that is done, 0 to 1; 0 where the whole is unknown.
        double share() const {
            if (total == 0) return 0.0;
            return done < total ? double(done) / double(total) : 1.0;
        }
    };

    /// Begins round `round` of `rounds`; round 0 begins anew.
    void begin_round(std::size_t round, std::size_t rounds) {
        const std::lock_guard lock(mutex_);
        round_start_ = Clock::now();
        if (round == 0) first_start_ = round_start_;
        state_.round = round, state_.rounds = rounds;
        state_.past.clear(), state_.total = 0, state_.counts_texels = false;
    }
    /// Begins a task; `task` is text that stays.
    void begin(std::string_view task, std::uint64_t total = 0, bool counts_texels = false) {
        const std::lock_guard lock(mutex_);
        const Clock::time_point now = Clock::now();
        if (state_.total > 0) state_.past.push_back({state_.task, seconds(now - task_start_)});
        task_start_ = now;
        state_.task = task, state_.total = total, state_.counts_texels = counts_texels;
        ++state_.number;
        done_.store(0, std::memory_order_relaxed);
    }
    void add(std::uint64_t units) { done_.fetch_add(units, std::memory_order_relaxed); }

    Reading read() const {
        const std::lock_guard lock(mutex_);
        const auto now = Clock::now();
        Reading reading = state_;
        reading.done = done_.load(std::memory_order_relaxed);
        reading.seconds = seconds(now - task_start_);
        reading.round_seconds = seconds(now - round_start_);
        reading.earlier_seconds = seconds(round_start_ - first_start_);
        return reading;
    }

  private:
    static double seconds(Clock::duration time) {
        return std::chrono::duration<double>(time).count();
    }

    mutable std::mutex mutex_;
    Reading state_{};
    Clock::time_point task_start_ = Clock::now(), round_start_ = task_start_,
                      first_start_ = task_start_;
    alignas(64) std::atomic<std::uint64_t> done_ = 0;
};

}  // namespace burl
