#pragma once
// The tool that moves the texture on the object: left drags on the surface and on the gizmo's
// handles become the recipe's transform, one gesture from press to release.
#include <imgui.h>

#include <optional>

#include "app/editor/panels/items.h"
#include "app/editor/panels/panels.h"
#include "app/editor/tools/grab.h"

namespace burl {

class EditMove {
  public:
    bool on = false;  ///< the pointer moves the texture
    bool shows_gizmo = true;

    /// Takes the pointer where the last item, the view, has it. True: it moves the texture; false:
    /// the view may have it. Escape takes the gesture back. Arrow keys do the same in steps, while
    /// no other window has them.
    bool input(const ObjectView& view, EditSession& session);
    /// The gizmo, and what is held.
    void draw(const ObjectView& view, EditSession& session, EditItems& items);

  private:
    void step(const ObjectView& view, EditSession& session) const;
    void press(const ObjectView& view, EditSession& session, const Vec2d& pointer);
    void follow(const ObjectView& view, EditSession& session, const Vec2d& pointer);
    void drop(EditSession& session);
    std::optional<SolidGizmo> gizmo(const ObjectView& view, const SolidOptions& solid) const;

    std::optional<SolidGrab> grab_{};
    Recipe before_{};                ///< as the gesture began
    std::optional<Vec3d> anchor_{};  ///< where the gizmo stands, in the texture
    Vec2d pointer_{0.0};             ///< which the recipe has followed
};

/// The tool's hints and settings, in a small window at the left upper corner of the object's view.
void move_panel(const PanelContext& context, EditMove& tool, const ImVec2& low);

}  // namespace burl
