#pragma once
// When the editor draws frames. While a mesh is opened, drawing by a software OpenGL competes with
// that for processors, so it gets a share of the time only; with a graphics card every refresh of
// the display still has its frame. While nothing happens, none is drawn.
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

/// Which turns of the frame loop draw while nothing moves by itself: after input one frame and
/// three more, which Dear ImGui needs to come to rest, and four within the second after, so that
/// tips come and fades end; after news of another thread two. Then none.
class EditRest {
  public:
    static constexpr double late_seconds = 0.25;  ///< between the frames of the second after input

    /// Asks for so many more frames at once.
    void ask(int frames) { at_once_ = std::max(at_once_, frames); }
    /// The longest time, in seconds, to wait for input and news: 0 where a frame is due at once.
    double patience() const { return at_once_ > 0 ? 0.0 : late_ > 0 ? late_seconds : 1.0; }
    /// Takes what a wait of so many seconds brought; returns whether a frame is due.
    bool ended(bool input, bool news, double waited) {
        if (input) {
            at_once_ = 3;
            late_ = 4;
        } else if (at_once_ > 0) {
            --at_once_;
        } else if (news) {
            at_once_ = 1;
        } else if (late_ > 0 && waited > 0.9 * late_seconds) {
            --late_;
        } else {
            return false;
        }
        return true;
    }

  private:
    int at_once_ = 3, late_ = 0;  ///< frames still to draw
};

/// Whether all events are moves of the pointer.
inline bool passes_by(std::span<const InputEvent> events) {
    return std::ranges::all_of(
        events, [](const InputEvent& event) { return event.kind == InputKind::move; });
}

}  // namespace burl
