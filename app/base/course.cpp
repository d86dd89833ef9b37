#include "app/base/course.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace burl {

namespace {

/// The least share of a task, and the least seconds, whose pace says how long the rest takes.
constexpr double least_share = 0.005, least_seconds = 0.3;

/// The share of what was expected of all tasks, and of the one under way as it begins, that counts
/// as much as what they have taken.
constexpr double share_of_expected = 0.2;

using Expected = std::vector<ExpectedTask>;

/// The place among those expected of the task that began after `earlier` others of its name.
Expected::const_iterator place_of(const Expected& expected, std::string_view task,
                                  std::ptrdiff_t earlier) {
    auto found = std::ranges::find(expected, task, &ExpectedTask::task);
    for (; earlier > 0 && found != expected.end(); --earlier) {
        const auto next = std::find_if(found + 1, expected.end(),
                                       [&](const ExpectedTask& one) { return one.task == task; });
        if (next == expected.end()) break;
        found = next;
    }
    return found;
}

bool has_pace(const TaskMeter::Reading& reading) {
    return reading.share() >= least_share && reading.seconds >= least_seconds;
}

/// How many times as long as expected tasks take, by those that are over and the one under way.
double slowness(const TaskMeter::Reading& reading, const Expected& expected,
                const ExpectedTask& now) {
    double meant = 0.0, took = 0.0;
    for (const ExpectedTask& task : expected) meant += share_of_expected * task.seconds;
    took = meant;
    for (auto past = reading.past.begin(); past != reading.past.end(); ++past) {
        const auto same = [&](const TaskMeter::Past& one) { return one.task == past->task; };
        const auto place =
            place_of(expected, past->task, std::count_if(reading.past.begin(), past, same));
        if (place == expected.end() || place->seconds == 0.0) continue;
        meant += place->seconds, took += past->seconds;
    }
    if (has_pace(reading) && now.seconds > 0.0)
        meant += reading.share() * now.seconds, took += reading.seconds;
    return meant > 0.0 ? took / meant : 1.0;
}

/// The seconds left of the task under way, of which so many were expected in all; none: not known.
/// The expectation gives way to the pace, as a task may have something to prepare.
std::optional<double> left_of_task(const TaskMeter::Reading& reading, double all) {
    const double share = reading.share(), rest = 1.0 - share;
    const double prior = all > 0.0 ? share_of_expected * rest * rest : 0.0;
    if (!has_pace(reading) && all == 0.0) return std::nullopt;
    if (reading.total == 0 || !has_pace(reading)) return std::max(0.0, all - reading.seconds);
    return rest * (reading.seconds + prior * all) / (share + prior);
}

std::optional<double> left_of_round(const TaskMeter::Reading& reading, const Expected& expected) {
    const auto same = [&](const TaskMeter::Past& one) { return one.task == reading.task; };
    const auto found = place_of(expected, reading.task, std::ranges::count_if(reading.past, same));
    if (found == expected.end()) return std::nullopt;
    const double slow = slowness(reading, expected, *found);
    std::optional<double> left = left_of_task(reading, slow * found->seconds);
    if (!left) return left;
    for (auto later = found + 1; later != expected.end(); ++later) *left += slow * later->seconds;
    return left;
}

}  // namespace

TimeLeft time_left(const TaskMeter::Reading& reading, const std::vector<ExpectedTask>& expected) {
    std::optional<double> left = left_of_round(reading, expected);
    const auto after = double(reading.rounds - reading.round - 1);
    if (reading.round > 0) {
        const double mean = reading.earlier_seconds / double(reading.round);
        left = left.value_or(std::max(0.0, mean - reading.round_seconds)) + after * mean;
    } else if (after > 0.0 && left) {
        left = *left + after * (reading.round_seconds + *left);
    }
    if (!left) return {};
    const double spent = reading.earlier_seconds + reading.round_seconds;
    return {left, spent + *left > 0.0 ? spent / (spent + *left) : 0.0};
}

void Course::begin_item(const std::string& name, std::size_t number, std::size_t of,
                        std::string_view task) {
    const std::lock_guard lock(mutex_);
    item_ = name, number_ = number, of_ = of;
    expected_.clear();
    meter_.begin_round(0, 1);
    meter_.begin(task);
}

void Course::expect(std::vector<ExpectedTask> tasks) {
    const std::lock_guard lock(mutex_);
    expected_ = std::move(tasks);
}

ProgressState Course::state() {
    const std::lock_guard lock(mutex_);
    const TaskMeter::Reading reading = meter_.read();
    const TimeLeft left = time_left(reading, expected_);
    ProgressState state{item_,         number_,       of_, std::string(reading.task),
                        reading.round, reading.rounds};
    state.seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    share_ = std::max(share_, (double(number_) + left.share) / double(of_));
    state.share = share_;
    if (of_ == 1)
        state.seconds_left = left.seconds;
    else if (share_ > 0.0)
        state.seconds_left = state.seconds * (1.0 - share_) / share_;
    if (reading.counts_texels && reading.done > 0 && reading.seconds > 0.0)
        state.texels_per_second = double(reading.done) / reading.seconds;
    return state;
}

}  // namespace burl
