#pragma once
// The timeline below the object: clock, scrub bar, and the keys of animated numbers as diamonds.
#include "app/editor/panels/panels.h"
#include "app/editor/session/session.h"

namespace burl {

/// The timeline's height in screen coordinates.
float timeline_height(const EditSession& session);

/// Draws the timeline at the position set for ImGui's next window.
void timeline_panel(const PanelContext& context);

/// Handles the keys of the timeline: K, and while it is open Space, I and Delete.
void timeline_shortcuts(EditSession& session);

/// Adds a key with the present value of the number edited last at the clock's time, or removes the
/// key it has there.
void toggle_key(EditSession& session);

}  // namespace burl
