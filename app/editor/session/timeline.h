#pragma once
// The editor's clock over a keyed recipe: what plays, where it is, and what of the timeline is
// chosen. It knows neither windows nor Dear ImGui.
#include <cstddef>
#include <string>

#include "app/editor/session/session.h"

namespace burl {

/// A key of a track; an empty path: none.
struct KeyChoice {
    std::string path{};
    std::size_t key = 0;
    bool operator==(const KeyChoice&) const = default;
};

struct EditTimeline {
    bool open = false, playing = false;
    bool scrubbing = false;  ///< the pointer holds the time
    KeyChoice chosen{};

    /// A picture will soon be another one.
    bool moving() const { return playing || scrubbing; }
};

/// Where the clock is after `dt` more seconds; `ended`: at the end of what does not loop.
struct ClockStep {
    double seconds = 0.0;
    bool ended = false;
};
ClockStep clock_after(const KeyedAnimation& animation, double seconds, double dt);

/// Plays, from the beginning where it stands at the end; or stops, on a frame.
void toggle_playing(EditTimeline& timeline, EditSession& session);

/// Lets so much time pass.
void advance(EditTimeline& timeline, EditSession& session, double dt);

}  // namespace burl
