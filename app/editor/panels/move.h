#pragma once
// The tool that moves the texture on the object: drags on the surface and on the gizmo's handles
// change the recipe's transform, each as one undo step.
#include <imgui.h>

#include <optional>

#include "app/editor/panels/panels.h"
#include "app/editor/tools/grab.h"
#include "app/editor/widgets/items.h"

namespace burl {

/// The move tool. All functions are called by the user interface's thread.
class EditMove {
  public:
    bool on = false;  ///< whether the tool is active
    bool shows_gizmo = true;

    /// Handles the pointer over ImGui's last item, the object's view, and the arrow keys unless
    /// another window has the keyboard's focus. Returns whether the tool takes the pointer;
    /// otherwise the camera may. Escape undoes the drag.
    bool input(const ObjectView& view, EditSession& session);
    /// Draws the gizmo and the gripped point.
    void draw(const ObjectView& view, EditSession& session, EditItems& items);

  private:
    void step(const ObjectView& view, EditSession& session) const;
    void press(const ObjectView& view, EditSession& session, const Vec2d& pointer);
    void follow(const ObjectView& view, EditSession& session, const Vec2d& pointer);
    void drop(EditSession& session);
    std::optional<SolidGizmo> gizmo(const ObjectView& view, const SolidOptions& solid) const;

    std::optional<SolidGrab> grab_{};
    Recipe before_{};                ///< recipe before the drag
    std::optional<Vec3d> anchor_{};  ///< texture's point at which the gizmo stands
    Vec2d pointer_{0.0};             ///< pointer position that the recipe has followed
};

/// Draws the tool's hints and settings in a small window in the upper left corner of the object's
/// view, at `low`.
void move_panel(const PanelContext& context, EditMove& tool, const ImVec2& low);

}  // namespace burl
