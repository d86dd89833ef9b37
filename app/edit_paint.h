#pragma once
// Painting on the object's view: the pointer's places become strokes of the recipe, one gesture
// from press to release, and the brush is seen as a ring on the surface.
#include <imgui.h>

#include <memory>
#include <optional>

#include "app/edit_camera.h"
#include "app/edit_session.h"
#include "app/paint_tool.h"
#include "app/surface_pick.h"

namespace burl {

/// What the object's view shows and where.
struct PaintView {
    std::shared_ptr<const SurfacePick> pick{};  ///< null: nothing can be painted yet
    Affine3 solid_from_mesh{};
    EditCamera camera{};
    Sphere sphere{};
    ImVec2 low{}, size{};  ///< on the screen
};

class EditPaint {
  public:
    PaintTool tool{};

    /// Takes the pointer where the last item, the view, has it. True: it paints; false: the view
    /// may have it, as where a drag began beside the object.
    bool input(const PaintView& view, EditSession& session);
    /// The ring under the pointer.
    void draw(const PaintView& view) const;

  private:
    void lead_to(const PaintView& view, EditSession& session, const ImVec2& pointer);

    bool painting_ = false;
    std::optional<ImVec2> last_{};  ///< where the stroke under way has met the surface
};

}  // namespace burl
