#pragma once
// Draws the gizmo over the object.
#include <optional>

#include "app/editor/panels/items.h"
#include "app/editor/tools/solid_gizmo.h"
#include "app/editor/tools/view.h"

namespace burl {

/// `lit` is drawn bright: under the pointer or held.
void draw_gizmo(const SolidGizmo& gizmo, const ObjectView& view,
                const std::optional<GizmoHandle>& lit);

/// Handles become items "gizmo.move.x", "gizmo.turn.x", ..., "gizmo.size", where they can be taken.
void note_gizmo(const SolidGizmo& gizmo, const ObjectView& view, EditItems& items);

}  // namespace burl
