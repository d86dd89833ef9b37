#pragma once
// Frame pacing while the editor opens a mesh: with software OpenGL drawing competes with the
// opening of the mesh for processors, so it gets a share of the time only. With a graphics card
// every refresh of the display still has its frame.
#include <algorithm>
#include <chrono>
#include <span>

#include "app/editor/session/input.h"

namespace burl {

/// Time at which the next frame is due, from the time that the last one took.
class EditPace {
  public:
    using Clock = std::chrono::steady_clock;

    /// Notes that a frame which took `took` ends now.
    void drew(Clock::duration took) { due_ = Clock::now() + rest_after(took); }
    /// The seconds until the next frame is due; 0: it is due.
    double seconds_left() const {
        return std::max(0.0, std::chrono::duration<double>(due_ - Clock::now()).count());
    }

    /// The pause after a frame that took `took`: four times as long, so that drawing has a fifth of
    /// the time, but at most 1/8 s.
    static Clock::duration rest_after(Clock::duration took) {
        return std::min<Clock::duration>(4 * took, std::chrono::milliseconds(125));
    }

  private:
    Clock::time_point due_{};
};

/// Whether all events are moves of the pointer.
inline bool passes_by(std::span<const InputEvent> events) {
    return std::ranges::all_of(
        events, [](const InputEvent& event) { return event.kind == InputKind::move; });
}

}  // namespace burl
