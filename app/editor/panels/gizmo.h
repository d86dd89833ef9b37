#pragma once
// Drawing of the transform gizmo over the object.
#include <optional>

#include "app/editor/panels/items.h"
#include "app/editor/tools/solid_gizmo.h"
#include "app/editor/tools/view.h"

namespace burl {

/// Draws the gizmo; the handle `lit`, under the pointer or held, is bright.
void draw_gizmo(const SolidGizmo& gizmo, const ObjectView& view,
                const std::optional<GizmoHandle>& lit);

/// Notes the visible handles as items "gizmo.move.x", "gizmo.turn.x", ..., "gizmo.size".
void note_gizmo(const SolidGizmo& gizmo, const ObjectView& view, EditItems& items);

}  // namespace burl
