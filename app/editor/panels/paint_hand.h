#pragma once
// Painting on the object's view: the pointer's places become strokes of the recipe, one gesture
// from press to release, and the brush is seen as a ring on the surface.
#include <optional>

#include "app/editor/session/session.h"
#include "app/editor/tools/view.h"
#include "app/paint/tool.h"

namespace burl {

class EditPaint {
  public:
    PaintTool tool{};

    /// Takes the pointer where the last item, the view, has it. True: it paints; false: the view
    /// may have it, as where a drag began beside the object.
    bool input(const ObjectView& view, EditSession& session);
    /// The ring under the pointer.
    void draw(const ObjectView& view) const;

  private:
    void lead_to(const ObjectView& view, EditSession& session, const Vec2d& pointer);

    bool painting_ = false;
    std::optional<Vec2d> last_{};  ///< where the stroke under way has met the surface
};

}  // namespace burl
