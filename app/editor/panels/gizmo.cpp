#include "app/editor/panels/gizmo.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "app/editor/tools/grab.h"

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
        constexpr std::array names{"x", "y", "z"};
        const ImVec2 size = ImGui::CalcTextSize(names[std::size_t(axis)]);
        list_.AddCircleFilled(middle, 0.55f * size.y, shadow);
        list_.AddText({middle.x - 0.5f * size.x, middle.y - 0.5f * size.y}, color,
                      names[std::size_t(axis)]);
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

}  // namespace

void draw_gizmo(const SolidGizmo& gizmo, const ObjectView& view,
                const std::optional<GizmoHandle>& lit) {
    if (!can_be_held(gizmo, gizmo_view(view), GizmoHandle{})) return;
    const Drawing drawing(gizmo, view, lit);
    for (int axis = 0; axis < 3; ++axis) drawing.ring(axis, false);
    for (int axis = 0; axis < 3; ++axis) drawing.ring(axis, true);
    for (int axis = 0; axis < 3; ++axis) drawing.arrow(axis);
    drawing.square();
}

void note_gizmo(const SolidGizmo& gizmo, const ObjectView& view, EditItems& items) {
    for (const GizmoHandle& handle : gizmo_handles) {
        const auto place = place_of(gizmo, gizmo_view(view), handle);
        if (!place) continue;
        const Vec2d at = *place + view.low;
        items.note(name_of(handle), ItemRect{at - Vec2d(2.0), at + Vec2d(2.0)});
    }
}

}  // namespace burl
