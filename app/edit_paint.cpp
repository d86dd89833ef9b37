#include "app/edit_paint.h"

#include <algorithm>
#include <cmath>

namespace burl {

namespace {

constexpr int ring_points = 48;
constexpr int most_steps = 200;  // places between two of the pointer's

PictureSize picture_size(const PaintView& view) {
    return {int(view.size.x), int(view.size.y)};
}

std::optional<SurfaceHit> hit_at(const PaintView& view, const ImVec2& pointer) {
    if (!view.pick) return {};
    const Vec2d pixel(double(pointer.x - view.low.x), double(pointer.y - view.low.y));
    return view.pick->meet(ray_of(view.camera, view.sphere, picture_size(view), pixel));
}

double solid_units(const PaintView& view) {
    return glm::length(view.solid_from_mesh.linear[0]);
}

/// Pixels that a solid unit has at the place hit.
double pixels_per_unit(const PaintView& view, const SurfaceHit& hit) {
    const double focal = camera_of(view.camera, view.sphere, picture_size(view)).focal_y;
    return 0.5 * double(view.size.y) * focal / (hit.depth * solid_units(view));
}

Vec3d normal_at(const SurfacePick& pick, const SurfaceHit& hit) {
    const Surface& surface = pick.scene().surfaces[hit.surface];
    const Triangle& t = surface.triangles[hit.triangle];
    const Vec3d &a = surface.positions[t[0]], &b = surface.positions[t[1]],
                &c = surface.positions[t[2]];
    return Mat3d(surface.placements[hit.placement]) * glm::cross(b - a, c - a);
}

bool is_over(const PaintView& view, const ImVec2& pointer) {
    return pointer.x >= view.low.x && pointer.y >= view.low.y &&
           pointer.x < view.low.x + view.size.x && pointer.y < view.low.y + view.size.y;
}

}  // namespace

/// Follows the surface between the pointer's places, so that quick hands leave no gaps.
void EditPaint::lead_to(const PaintView& view, EditSession& session, const ImVec2& pointer) {
    const std::optional<SurfaceHit> hit = hit_at(view, pointer);
    if (!hit) {
        last_.reset();
        return;
    }
    const ImVec2 from = last_.value_or(pointer);
    const double pixels = std::hypot(double(pointer.x - from.x), double(pointer.y - from.y));
    const double step = std::max(0.5, 0.5 * tool.brush.radius * pixels_per_unit(view, *hit));
    const int steps = std::clamp(int(std::ceil(pixels / step)), 1, most_steps);
    Recipe recipe = session.recipe();
    bool leads = last_.has_value();
    for (int k = 1; k <= steps; ++k) {
        const float t = float(k) / float(steps);
        const auto place =
            hit_at(view, {from.x + t * (pointer.x - from.x), from.y + t * (pointer.y - from.y)});
        if (place)
            recipe =
                painted_at(std::move(recipe), tool, view.solid_from_mesh(place->mesh_point), leads);
        leads = place.has_value();
    }
    last_ = pointer;
    session.history().change(std::move(recipe));
}

bool EditPaint::input(const PaintView& view, EditSession& session) {
    const ImGuiIO& io = ImGui::GetIO();
    EditHistory& history = session.history();
    const bool began = tool.on && ImGui::IsItemActivated() && ImGui::IsMouseClicked(0) &&
                       !io.KeyAlt && !io.KeyCtrl && hit_at(view, io.MousePos);
    if (began) {
        painting_ = true;
        last_.reset();
        history.begin_gesture();
    }
    if (!painting_) return false;
    if (ImGui::IsMouseDown(0) && tool.on && history.in_gesture())  // nobody has undone it
        lead_to(view, session, io.MousePos);
    else {
        painting_ = false;
        history.end_gesture();
    }
    return true;
}

void EditPaint::draw(const PaintView& view) const {
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    if (!tool.on || !is_over(view, pointer)) return;
    const auto hit = hit_at(view, pointer);
    if (!hit) return;
    const Camera camera = camera_of(view.camera, view.sphere, picture_size(view));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto ring = [&](double radius, ImU32 color, float width) {
        std::vector<ImVec2> points;
        for (const Vec3d& p : circle(hit->point, normal_at(*view.pick, *hit),
                                     radius / solid_units(view), ring_points)) {
            const Vec3d seen = project(camera, picture_size(view), p);
            points.push_back({view.low.x + float(seen.x), view.low.y + float(seen.y)});
        }
        list.AddPolyline(points.data(), ring_points, color, ImDrawFlags_Closed, width);
    };
    const Rgb8& c = tool.brush.color;
    const bool erases = tool.brush.mode == PaintMode::erase;
    ring(tool.brush.radius, IM_COL32(0, 0, 0, 200), 4.0f);
    ring(tool.brush.radius, erases ? IM_COL32(255, 255, 255, 255) : IM_COL32(c.r, c.g, c.b, 255),
         2.0f);
    ring(tool.brush.hardness * tool.brush.radius, IM_COL32(255, 255, 255, 110), 1.0f);
}

}  // namespace burl
