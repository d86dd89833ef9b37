#pragma once
// The brush's settings, in a small window over the object while painting.
#include "app/editor/panels/panels.h"
#include "app/paint/tool.h"

namespace burl {

/// Handles the tool's keys while it is on: comma and period change the radius, X switches between
/// brush and eraser.
void paint_shortcuts(PaintTool& tool);

/// Draws the settings in the upper left corner of the object's view, at `low`, while the tool is
/// on.
void paint_panel(const PanelContext& context, PaintTool& tool, const ImVec2& low);

/// Removes all paint as one step.
void clear_paint(EditSession& session);

}  // namespace burl
