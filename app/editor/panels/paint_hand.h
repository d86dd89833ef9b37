#pragma once
// Painting in the object's view: pointer positions become strokes of the recipe, one undo step from
// press to release, and the brush is drawn as a ring on the surface.
#include <optional>

#include "app/editor/session/session.h"
#include "app/editor/tools/view.h"
#include "app/paint/tool.h"

namespace burl {

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
