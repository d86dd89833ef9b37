#pragma once
// The brush's settings, in a small window over the object while painting.
#include "app/editor/panels/panels.h"
#include "app/paint/tool.h"

namespace burl {

/// Keys of the mode while it is on: comma and period change the radius, X takes the eraser or the
/// brush.
void paint_shortcuts(PaintTool& tool);

/// `low`: the left upper corner of the object's view. Nothing while the tool is off.
void paint_panel(const PanelContext& context, PaintTool& tool, const ImVec2& low);

/// Takes all paint away, as one step.
void clear_paint(EditSession& session);

}  // namespace burl
