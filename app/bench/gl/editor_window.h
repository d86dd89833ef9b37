#pragma once
// An offscreen 60 Hz display in real time: a callback makes input at that rate, and every frame is
// finished and then waits for the next refresh.
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "app/base/json_text.h"
#include "app/editor/window/window.h"

namespace burl {

/// Percentiles of durations, in milliseconds.
struct Durations {
    double median = 0.0, p95 = 0.0, longest = 0.0;
};
/// Computes the percentiles; 0 where there are no durations.
Durations durations_of(std::vector<double> milliseconds);
Json durations_json(const Durations& durations);

/// The processor time of all threads so far, in seconds.
double processor_seconds();

/// A window for benchmarks. All functions except wake() are called by one thread.
class BenchWindow final : public GlWindow {
  public:
    static constexpr double refresh_seconds = 1.0 / 60.0;
    /// A frame from the end of poll() to the end of its drawing, in seconds().
    struct Frame {
        double begin = 0.0, end = 0.0;
    };

    BenchWindow(std::unique_ptr<GlContext> context, const glm::ivec2& size);

    /// Sets the callback asked for input 60 times a second; an empty function: no input.
    void set_hand(std::function<std::vector<InputEvent>(double seconds)> hand);
    /// Sets the callback that receives every frame's times before the frame is presented.
    void on_frame(std::function<void(const Frame&)> told) { told_ = std::move(told); }

    GlContext& context() override { return window_->context(); }
    glm::ivec2 size() const override { return window_->size(); }
    glm::ivec2 pixels() const override { return window_->pixels(); }
    void bind_screen() override { window_->bind_screen(); }
    void present() override;
    std::vector<InputEvent> poll(double seconds) override;
    void wake() override;
    bool take_news() override { return std::exchange(news_, false); }
    void resize(const glm::ivec2& size) override { window_->resize(size); }
    void set_title(const std::string&) override {}
    std::string clipboard() const override { return {}; }
    void set_clipboard(const std::string&) override {}
    double seconds() const override;

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point time_at(double seconds) const;

    std::unique_ptr<GlWindow> window_;
    Clock::time_point start_ = Clock::now();
    std::function<std::vector<InputEvent>(double)> hand_;
    std::function<void(const Frame&)> told_;
    double next_events_ = 0.0, began_ = 0.0;
    // `mutex_` guards woken_, and `changed_` is notified when it becomes true.
    std::mutex mutex_;
    std::condition_variable changed_;
    bool woken_ = false;
    bool news_ = false;  ///< whether poll() found woken_ set; of the thread that draws
};

}  // namespace burl
