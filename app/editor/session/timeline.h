#pragma once
// The editor's clock for a recipe with animation tracks, and the selection on its timeline.
// Independent of windows and Dear ImGui.
#include <cstddef>
#include <string>

#include "app/editor/session/session.h"

namespace burl {

/// A selected key of the track at `path`; an empty path: none.
struct KeyChoice {
    std::string path{};
    std::size_t key = 0;
    bool operator==(const KeyChoice&) const = default;
};

/// The state of the timeline panel.
struct EditTimeline {
    /// Whether the panel is shown, and whether the animation plays.
    bool open = false, playing = false;
    bool scrubbing = false;  ///< the pointer drags the time
    KeyChoice chosen{};

    /// Whether the time is about to change, so that a coarse level of the texture is enough.
    bool moving() const { return playing || scrubbing; }
};

/// The time `dt` seconds later; `ended`: the end of an animation that does not loop.
struct ClockStep {
    double seconds = 0.0;
    bool ended = false;
};
ClockStep clock_after(const KeyedAnimation& animation, double seconds, double dt);

/// Starts playing, from the beginning where the clock is at the end; or stops at the nearest frame.
void toggle_playing(EditTimeline& timeline, EditSession& session);

/// Advances the session's clock by `dt` seconds while the animation plays.
void advance(EditTimeline& timeline, EditSession& session, double dt);

}  // namespace burl
