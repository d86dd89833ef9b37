#include "app/editor/panels/move.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <imgui.h>

#include "app/editor/tools/grab.h"
#include "app/editor/tools/solid_gizmo.h"
#include "app/editor/tools/view.h"
#include "app/editor/widgets/items.h"
#include "app/editor/widgets/keys.h"
#include "app/editor/widgets/widgets.h"

namespace burl {

namespace {

constexpr std::array<ImU32, 3> colors{IM_COL32(235, 64, 52, 255), IM_COL32(88, 196, 62, 255),
                                      IM_COL32(66, 133, 255, 255)};
constexpr ImU32 bright = IM_COL32(255, 226, 92, 255), shadow = IM_COL32(0, 0, 0, 150),
                handle_color = IM_COL32(240, 240, 240, 255);
// Widths in pixels; the outline is on both sides of the line.
constexpr float line_width = 2.5f, outline = 2.0f;
constexpr float head_length = 13.0f, head_width = 5.5f;
constexpr unsigned faint = 70;  // opacity of a ring's far half, 0 to 255

ImU32 with_opacity(ImU32 color, unsigned opacity) {
    return (color & ~IM_COL32_A_MASK) | opacity << IM_COL32_A_SHIFT;
}

class Drawing {
  public:
    Drawing(const SolidGizmo& gizmo, const ObjectView& view, const std::optional<GizmoHandle>& lit)
        : gizmo_(gizmo), view_(view), lit_(lit), list_(*ImGui::GetWindowDrawList()) {}

    /// Draws the near or the far half of a ring as one line.
    void ring(int axis, bool near_half) const {
        const Vec3d to_eye = camera_of(view_).eye - gizmo_.centre;
        // The halves overlap a little, so that no gap shows between them.
        const double overlap = 0.1 * gizmo_ring * gizmo_.length * glm::length(to_eye);
        const auto shown = [&](const Vec3d& p) {
            const double towards = glm::dot(p - gizmo_.centre, to_eye);
            return (near_half ? towards : -towards) >= -overlap;
        };
        std::vector<Vec3d> points = ring_points(gizmo_, axis);
        const auto hidden = std::ranges::find_if_not(points, shown);
        std::ranges::rotate(points, hidden);  // the half's points are contiguous then
        std::vector<ImVec2> half;
        for (const Vec3d& p : points)
            if (shown(p)) half.push_back(at(p));
        const ImU32 color = color_of({GizmoPart::ring, axis});
        const int count = int(half.size());
        const ImDrawFlags closed = half.size() == points.size() ? ImDrawFlags_Closed : 0;
        if (near_half) list_.AddPolyline(half.data(), count, shadow, closed, line_width + outline);
        list_.AddPolyline(half.data(), count, near_half ? color : with_opacity(color, faint),
                          closed, line_width);
    }

    void arrow(int axis) const {
        const GizmoHandle handle{GizmoPart::arrow, axis};
        if (!can_be_held(gizmo_, gizmo_view(view_), handle)) return;
        const ImVec2 tail = at(gizmo_.centre), tip = at(arrow_tip(gizmo_, axis));
        const ImVec2 way(tip.x - tail.x, tip.y - tail.y);
        const float length = std::sqrt(way.x * way.x + way.y * way.y);
        const ImVec2 u(way.x / length, way.y / length);
        const ImVec2 neck(tip.x - head_length * u.x, tip.y - head_length * u.y);
        const ImU32 color = color_of(handle);
        list_.AddLine(tail, neck, shadow, line_width + outline);
        list_.AddLine(tail, neck, color, line_width);
        head(tip, neck, u, head_width + 0.5f * outline, shadow);
        head(tip, neck, u, head_width, color);
        letter({tip.x + 11.0f * u.x, tip.y + 11.0f * u.y}, axis, color);
    }

    void square() const {
        const ImVec2 middle = at(gizmo_.centre);
        const auto half = float(gizmo_square) - 1.0f;
        const ImVec2 low(middle.x - half, middle.y - half), high(middle.x + half, middle.y + half);
        list_.AddRectFilled(low, high, lit_ == GizmoHandle{} ? bright : handle_color, 2.0f);
        list_.AddRect(low, high, IM_COL32(0, 0, 0, 220), 2.0f, 0, 1.5f);
    }

  private:
    ImVec2 at(const Vec3d& point) const {
        const Vec3d seen = on_screen(view_, point);
        return {float(seen.x), float(seen.y)};
    }
    ImU32 color_of(const GizmoHandle& handle) const {
        return lit_ == handle ? bright : colors[std::size_t(handle.axis)];
    }
    void letter(const ImVec2& middle, int axis, ImU32 color) const {
        constexpr std::array letters{"x", "y", "z"};
        const ImVec2 size = ImGui::CalcTextSize(letters[std::size_t(axis)]);
        list_.AddCircleFilled(middle, 0.55f * size.y, shadow);
        list_.AddText({middle.x - 0.5f * size.x, middle.y - 0.5f * size.y}, color,
                      letters[std::size_t(axis)]);
    }
    void head(const ImVec2& tip, const ImVec2& neck, const ImVec2& u, float width,
              ImU32 color) const {
        list_.AddTriangleFilled(tip, {neck.x - width * u.y, neck.y + width * u.x},
                                {neck.x + width * u.y, neck.y - width * u.x}, color);
    }

    const SolidGizmo& gizmo_;
    const ObjectView& view_;
    const std::optional<GizmoHandle>& lit_;
    ImDrawList& list_;
};

std::string name_of(const GizmoHandle& handle) {
    if (handle.part == GizmoPart::square) return "gizmo.size";
    return fmt::format("gizmo.{}.{}", handle.part == GizmoPart::arrow ? "move" : "turn",
                       "xyz"[handle.axis]);
}

/// Draws the gizmo; the handle `lit`, under the pointer or held, is bright.
void draw_gizmo(const SolidGizmo& gizmo, const ObjectView& view,
                const std::optional<GizmoHandle>& lit) {
    if (!can_be_held(gizmo, gizmo_view(view), GizmoHandle{})) return;
    const Drawing drawing(gizmo, view, lit);
    for (int axis = 0; axis < 3; ++axis) drawing.ring(axis, false);
    for (int axis = 0; axis < 3; ++axis) drawing.ring(axis, true);
    for (int axis = 0; axis < 3; ++axis) drawing.arrow(axis);
    drawing.square();
}

/// Notes the visible handles as items "gizmo.move.x", "gizmo.turn.x", ..., "gizmo.size".
void note_gizmo(const SolidGizmo& gizmo, const ObjectView& view, EditItems& items) {
    for (const GizmoHandle& handle : gizmo_handles) {
        const auto place = place_of(gizmo, gizmo_view(view), handle);
        if (!place) continue;
        const Vec2d at = *place + view.low;
        items.note(name_of(handle), ItemRect{at - Vec2d(2.0), at + Vec2d(2.0)});
    }
}

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
        check_box(context.items, "axes", "move.axes", tool.shows_gizmo);
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
