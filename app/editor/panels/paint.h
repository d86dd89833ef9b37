#pragma once
// Painting in the object's view: pointer positions become strokes of the recipe, one undo step from
// press to release, the brush is drawn as a ring on the surface, and its settings are in a small
// window over the object.
#include <optional>

#include "app/editor/panels/panels.h"
#include "app/editor/session/session.h"
#include "app/editor/tools/view.h"
#include "app/paint/tool.h"

namespace burl {

/// Handles the tool's keys while it is on: comma and period change the radius, X switches between
/// brush and eraser.
void paint_shortcuts(PaintTool& tool);

/// Draws the settings in the upper left corner of the object's view, at `low`, while the tool is
/// on.
void paint_panel(const PanelContext& context, PaintTool& tool, const ImVec2& low);

/// Removes the paint of a layer, or all paint, as one step.
void clear_paint(EditSession& session, std::optional<int> layer = {});

/// The paint tool. All functions are called by the user interface's thread.
class EditPaint {
  public:
    PaintTool tool{};

    /// Handles the pointer over ImGui's last item, the object's view. Returns whether the tool
    /// takes the pointer; otherwise, as for a drag that began beside the object, the camera may.
    bool input(const ObjectView& view, EditSession& session);
    /// Draws the brush's ring under the pointer.
    void draw(const ObjectView& view) const;

  private:
    void lead_to(const ObjectView& view, EditSession& session, const Vec2d& pointer);

    bool painting_ = false;
    std::optional<Vec2d> last_{};  ///< last pointer position on the surface in the present stroke
};

}  // namespace burl
