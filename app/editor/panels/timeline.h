#pragma once
// The timeline below the object: clock, scrub bar, and the keys of every number as diamonds.
#include "app/editor/panels/panels.h"
#include "app/editor/session/timeline.h"

namespace burl {

/// Height that the strip takes, in pixels.
float timeline_height(const EditSession& session);

/// Draws it where the next window is to be.
void timeline_panel(const PanelContext& context, EditTimeline& timeline);

/// Its keys: K, and while it is open Space, I and Delete.
void timeline_shortcuts(EditTimeline& timeline, EditSession& session);

/// The touched number gets a key of its value at the present time, or loses the one it has there.
void toggle_key(EditSession& session);

}  // namespace burl
