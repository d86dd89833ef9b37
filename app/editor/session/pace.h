#pragma once
// How often the editor draws while it opens a mesh: where OpenGL is software, frames take the
// processors that the mesh waits for, so that drawing gets a share of the time only. Where a
// graphics card draws, every refresh of the display still has its frame.
#include <chrono>
#include <span>

#include "app/editor/session/input.h"

namespace burl {

class EditPace {
  public:
    using Clock = std::chrono::steady_clock;

    /// A frame took so long and ends now.
    void drew(Clock::duration took) { due_ = Clock::now() + rest_after(took); }
    /// Until the next frame is due; 0: it is.
    double seconds_left() const;

    /// Drawing has a fifth of the time, but a frame is never more than an eighth of a second late.
    static Clock::duration rest_after(Clock::duration took);

  private:
    Clock::time_point due_{};
};

/// Whether all that happens is the pointer going over the window.
bool passes_by(std::span<const InputEvent> events);

}  // namespace burl
