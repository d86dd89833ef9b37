#include "app/editor/panels/move.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "app/editor/panels/gizmo.h"
#include "app/editor/panels/keys.h"
#include "app/editor/panels/scale.h"
#include "app/editor/panels/tool_window.h"

namespace burl {

namespace {

constexpr double arrow_pixels = 110.0;

SolidDrag drag_of(const ImGuiIO& io) {
    return io.KeyShift ? SolidDrag::turn : io.KeyCtrl ? SolidDrag::size : SolidDrag::move;
}

void change(EditSession& session, const SolidOptions& solid) {
    Recipe recipe = session.still();
    recipe.solid = solid;
    session.change_still(recipe);
}

/// Draws the gripped point, and a line to the pivot for turns and scalings.
void draw_hold(const ObjectView& view, const SolidGrab& grab) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto at = [&](const Vec3d& point) {
        const Vec3d seen = on_screen(view, point);
        return ImVec2(float(seen.x), float(seen.y));
    };
    const ImVec2 held = at(grab.held());
    constexpr ImU32 white = IM_COL32(255, 255, 255, 230), black = IM_COL32(0, 0, 0, 200);
    if (grab.drag() != SolidDrag::move) {
        const ImVec2 pivot = at(middle_of(view));
        list.AddLine(pivot, held, black, 3.0f);
        list.AddLine(pivot, held, white, 1.0f);
        list.AddCircleFilled(pivot, 3.5f, white);
    }
    list.AddCircle(held, 6.0f, black, 0, 4.0f);
    list.AddCircle(held, 6.0f, white, 0, 2.0f);
}

}  // namespace

std::optional<SolidGizmo> EditMove::gizmo(const ObjectView& view, const SolidOptions& solid) const {
    if (!view.pick || !shows_gizmo || !anchor_) return {};
    return gizmo_of(gizmo_view(view), solid, *anchor_, arrow_pixels * interface_scale());
}

void EditMove::press(const ObjectView& view, EditSession& session, const Vec2d& pointer) {
    const SolidOptions& solid = session.still().solid;
    const ImGuiIO& io = ImGui::GetIO();
    if (const auto shown = gizmo(view, solid))
        if (const auto handle = handle_at(*shown, gizmo_view(view), pointer - view.low))
            grab_ = SolidGrab::handle(*shown, *handle, solid, pointer);
    if (!grab_) grab_ = SolidGrab::surface(view, solid, drag_of(io), pointer);
    if (grab_) before_ = session.recipe();
    if (grab_) session.history().begin_gesture();
    pointer_ = pointer;
}

void EditMove::follow(const ObjectView& view, EditSession& session, const Vec2d& pointer) {
    if (pointer == pointer_) return;
    pointer_ = pointer;
    const auto solid = grab_->to(view, pointer);
    if (solid) change(session, *solid);
}

void EditMove::step(const ObjectView& view, EditSession& session) const {
    const bool elsewhere =
        ImGui::IsWindowFocused(ImGuiFocusedFlags_AnyWindow) && !ImGui::IsWindowFocused();
    if (elsewhere || ImGui::GetIO().WantTextInput) return;
    constexpr std::array<std::pair<const char*, Vec2d>, 4> arrows{
        {{"Left", {-1, 0}}, {"Right", {1, 0}}, {"Up", {0, 1}}, {"Down", {0, -1}}}};
    constexpr std::array<std::pair<const char*, SolidDrag>, 3> drags{
        {{"", SolidDrag::move}, {"Shift+", SolidDrag::turn}, {"Ctrl+", SolidDrag::size}}};
    for (const auto& [modifier, drag] : drags)
        for (const auto& [arrow, way] : arrows)
            if (pressed(fmt::format("{}{}", modifier, arrow)))
                change(session, stepped(view, session.still().solid, drag, way));
}

void EditMove::drop(EditSession& session) {
    grab_.reset();
    session.history().end_gesture();
}

bool EditMove::input(const ObjectView& view, EditSession& session) {
    const ImGuiIO& io = ImGui::GetIO();
    if (on && !grab_ && view.pick && ImGui::IsItemActivated() && ImGui::IsMouseClicked(0) &&
        !io.KeyAlt)
        press(view, session, pointer_now());
    if (on && !grab_ && view.pick) step(view, session);
    if (!grab_) return false;
    if (pressed("Escape")) {
        session.history().change(before_);  // restores the animation tracks, too
        drop(session);
    } else if (on && ImGui::IsMouseDown(0) && session.history().in_gesture()) {
        follow(view, session, pointer_now());
    } else {
        drop(session);
    }
    return true;
}

void EditMove::draw(const ObjectView& view, EditSession& session, EditItems& items) {
    if (!on || !view.pick) return;
    const SolidOptions& solid = session.still().solid;
    const GizmoView seen = gizmo_view(view);
    if (!grab_) anchor_ = gizmo_anchor(seen, solid, anchor_, view.sphere, middle_of(view));
    std::optional<GizmoHandle> lit = grab_ ? grab_->handle() : std::nullopt;
    if (const auto shown = gizmo(view, solid)) {
        if (!grab_ && ImGui::IsItemHovered())
            lit = handle_at(*shown, seen, pointer_now() - view.low);
        draw_gizmo(*shown, view, lit);
        note_gizmo(*shown, view, items);
    }
    if (grab_ && !grab_->handle()) draw_hold(view, *grab_);
}

void move_panel(const PanelContext& context, EditMove& tool, const ImVec2& low) {
    if (!tool.on) return;
    if (begin_tool_window("Move the texture (G)", tool.on, low)) {
        ImGui::TextUnformatted(
            "drag or arrow keys: move\nwith Shift: turn\nwith Ctrl: larger, smaller\n"
            "Escape: take it back\nAlt+drag: turn the object");
        ImGui::Checkbox("axes", &tool.shows_gizmo);
        context.items.note("move.axes");
        ImGui::SameLine();
        if (ImGui::Button("Reset")) {
            Recipe recipe = context.session.still();
            recipe.solid.rotate = recipe.solid.translate = Vec3d(0.0);
            context.session.history().end_gesture();
            context.session.change_still(recipe);
        }
        context.items.note("move.reset");
    }
    ImGui::End();
}

}  // namespace burl
