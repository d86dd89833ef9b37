#include "app/bench/gl/editor_window.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <thread>
#include <utility>

#include <glad/gl.h>

#include "atlas/base/json.h"

namespace burl {

Durations durations_of(std::vector<double> milliseconds) {
    if (milliseconds.empty()) return {};
    std::ranges::sort(milliseconds);
    const auto at = [&](double share) {
        return milliseconds[std::size_t(share * double(milliseconds.size() - 1) + 0.5)];
    };
    return {at(0.5), at(0.95), at(1.0)};
}

Json durations_json(const Durations& durations) {
    return {{"median", durations.median}, {"p95", durations.p95}, {"longest", durations.longest}};
}

double processor_seconds() {
    return double(std::clock()) / CLOCKS_PER_SEC;
}

BenchWindow::BenchWindow(std::unique_ptr<GlContext> context, const glm::ivec2& size)
    : window_(create_unseen_window(std::move(context), size)) {}

double BenchWindow::seconds() const {
    return std::chrono::duration<double>(Clock::now() - start_).count();
}

BenchWindow::Clock::time_point BenchWindow::time_at(double seconds) const {
    return start_ +
           std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

void BenchWindow::set_hand(std::function<std::vector<InputEvent>(double)> hand) {
    hand_ = std::move(hand);
    next_events_ = seconds();
}

void BenchWindow::wake() {
    {
        const std::scoped_lock lock(mutex_);
        woken_ = true;
    }
    changed_.notify_one();
}

std::vector<InputEvent> BenchWindow::poll(double seconds) {
    double until = this->seconds() + seconds;
    if (hand_) until = std::min(until, next_events_);
    {
        std::unique_lock lock(mutex_);
        changed_.wait_until(lock, time_at(until), [&] { return woken_; });
        news_ |= std::exchange(woken_, false);
    }
    began_ = this->seconds();
    if (!hand_ || began_ < next_events_) return {};
    next_events_ = std::max(next_events_ + refresh_seconds, began_);
    return hand_(began_);
}

void BenchWindow::present() {
    window_->context().gl().Finish();
    const Frame frame{began_, seconds()};
    if (told_) told_(frame);
    const double refresh = refresh_seconds * std::ceil(frame.end / refresh_seconds);
    std::this_thread::sleep_until(time_at(refresh));
    window_->present();
}

}  // namespace burl
