#include "app/base/progress.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>
#include <unistd.h>

#include "app/base/messages.h"
#include "atlas/base/json.h"

namespace burl {

namespace {

using std::chrono::milliseconds;
constexpr TaskMeter::Clock::duration line_delay = milliseconds(500),
                                     line_period = milliseconds(100),
                                     json_period = milliseconds(500);
constexpr TaskMeter::Clock::duration plain_period = std::chrono::seconds(10);
std::string duration_text(double seconds) {
    const auto whole = std::uint64_t(std::ceil(seconds));
    if (whole < 100) return fmt::format("{} s", whole);
    if (whole < 6000) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
    return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

/// A number's three leading digits, with the unit's prefix.
std::string rate_text(double per_second) {
    return per_second < 1e6 ? fmt::format("{:.3g} ktexel/s", per_second / 1e3)
                            : fmt::format("{:.3g} Mtexel/s", per_second / 1e6);
}

}  // namespace

ProgressMode progress_mode(std::string_view word, bool quiet) {
    const auto* const found = std::ranges::find(progress_modes, word);
    const auto mode = ProgressMode(found - progress_modes.begin());
    if (mode != ProgressMode::automatic) return mode;
    if (quiet) return ProgressMode::none;
    return ::isatty(STDERR_FILENO) == 1 ? ProgressMode::line : ProgressMode::plain;
}

std::string progress_text(const ProgressState& state) {
    std::string text;
    if (state.of > 1) text += fmt::format("{} of {}, ", state.number + 1, state.of);
    if (!state.item.empty()) text += state.item + ": ";
    text += state.task;
    if (state.rounds > 1) text += fmt::format(", frame {} of {}", state.round + 1, state.rounds);
    if (state.share > 0.0) text += fmt::format(", {:.0f} %", std::floor(100.0 * state.share));
    if (state.texels_per_second) text += ", " + rate_text(*state.texels_per_second);
    if (state.seconds_left) text += fmt::format(", {} left", duration_text(*state.seconds_left));
    return text;
}

std::string progress_json(const ProgressState& state) {
    const auto number = [](const std::optional<double>& value) {
        return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
    };
    return nlohmann::ordered_json{
        {"task", state.task},         {"item", state.item},
        {"number", state.number + 1}, {"of", state.of},
        {"frame", state.round + 1},   {"frames", state.rounds},
        {"share", state.share},       {"texels_per_second", number(state.texels_per_second)},
        {"seconds", state.seconds},   {"seconds_left", number(state.seconds_left)}}
        .dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

Progress::Progress(ProgressMode mode) : mode_(mode) {
    if (mode_ != ProgressMode::none)
        thread_ = std::jthread([this](const std::stop_token& stop) { watch(stop); });
}

Progress::~Progress() {
    stop();
}

/// Ends the thread and clears the line.
void Progress::stop() {
    if (!thread_.joinable()) return;
    thread_.request_stop();
    thread_.join();
    if (mode_ == ProgressMode::line) show_status("");
}

void Progress::finish() {
    stop();
    if (mode_ != ProgressMode::json) return;
    course_.meter().begin("done");
    ProgressState last = course_.state();
    last.share = 1.0, last.seconds_left = 0.0;
    warn(progress_json(last));
}

/// Tells the state as often as the mode says, until the program has something else to say.
void Progress::watch(const std::stop_token& stop) {
    using Clock = TaskMeter::Clock;
    const Clock::duration period = mode_ == ProgressMode::plain ? plain_period : line_period;
    Clock::time_point next = start_ + (mode_ == ProgressMode::line ? line_delay : period), told{};
    std::uint64_t task = 0;
    for (;; next = Clock::now() + period) {
        std::unique_lock lock(mutex_);
        changed_.wait_until(lock, stop, next, [] { return false; });
        lock.unlock();
        if (stop.stop_requested()) return;
        const std::uint64_t number = course_.meter().read().number;
        if (number == 0) continue;
        if (mode_ == ProgressMode::line) show_status(progress_text(course_.state()));
        if (mode_ == ProgressMode::plain) warn("burl: " + progress_text(course_.state()));
        if (mode_ != ProgressMode::json) continue;
        if (number == task && Clock::now() - told < json_period) continue;
        task = number, told = Clock::now();
        warn(progress_json(course_.state()));
    }
}

}  // namespace burl
