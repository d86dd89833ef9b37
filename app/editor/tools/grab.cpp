#include "app/editor/tools/grab.h"

namespace burl {

namespace {

constexpr double pivot_reach = 0.1, key_step = 0.02;  // lengths in radii of the object

double solid_units(const ObjectView& view) {
    return view.solid_from_mesh.linear[0][0];
}

DragPivot pivot_of(const ObjectView& view) {
    return {view.solid_from_mesh(middle_of(view)),
            pivot_reach * view.sphere.radius * solid_units(view), camera_of(view).back};
}

Mat4d mesh_from_scene(const ObjectView& view, const SurfaceHit& hit) {
    const std::vector<Mat4d>& placements = view.pick->scene().surfaces[hit.surface].placements;
    if (hit.placement == 0) return Mat4d(1.0);
    return placements[0] * glm::inverse(placements[hit.placement]);
}

}  // namespace

Vec3d middle_of(const ObjectView& view) {
    return -view.unit_from_mesh.offset / view.unit_from_mesh.linear[0][0];
}

GizmoView gizmo_view(const ObjectView& view) {
    return {camera_of(view), picture_size(view), view.solid_from_mesh};
}

SolidOptions stepped(const ObjectView& view, const SolidOptions& start, SolidDrag drag,
                     const Vec2d& way) {
    return stepped(start, drag, camera_of(view), view.solid_from_mesh(middle_of(view)), way,
                   key_step * view.sphere.radius * solid_units(view));
}

std::optional<SolidGrab> SolidGrab::surface(const ObjectView& view, const SolidOptions& start,
                                            SolidDrag drag, const Vec2d& pointer) {
    if (!hit_at(view, pointer)) return {};
    SolidGrab grab;
    grab.start_ = start;
    grab.drag_ = drag;
    grab.from_ = grab.solid_point(view, pointer);
    return grab;
}

SolidGrab SolidGrab::handle(const SolidGizmo& gizmo, const GizmoHandle& handle,
                            const SolidOptions& start, const Vec2d& pointer) {
    SolidGrab grab;
    grab.start_ = start;
    grab.handle_ = handle;
    grab.gizmo_ = gizmo;
    grab.pressed_ = pointer;
    grab.held_ = gizmo.centre;
    return grab;
}

/// Returns the solid point under the pointer. For scalings it lies in the plane through the middle,
/// parallel to the picture: on a round object all surface points are about as far from the middle.
Vec3d SolidGrab::solid_point(const ObjectView& view, const Vec2d& pointer) {
    const Camera camera = camera_of(view);
    const Ray ray = ray_at(view, pointer);
    if (drag_ == SolidDrag::size) {
        held_ = beside(camera, ray, middle_of(view));
        return view.solid_from_mesh(held_);
    }
    if (const auto hit = hit_at(view, pointer)) {
        held_ = hit->point;
        mesh_from_scene_ = mesh_from_scene(view, *hit);
        if (view.share != 0.0)
            rest_offset_ = hit->mesh_point - Vec3d(mesh_from_scene_ * Vec4d(held_, 1.0));
        return view.solid_from_mesh(hit->mesh_point);
    }
    held_ = beside(camera, ray, held_);
    return view.solid_from_mesh(Vec3d(mesh_from_scene_ * Vec4d(held_, 1.0)) + rest_offset_);
}

std::optional<SolidOptions> SolidGrab::to(const ObjectView& view, const Vec2d& pointer) {
    if (handle_)
        return pulled(start_, gizmo_, gizmo_view(view), *handle_, pressed_ - view.low,
                      pointer - view.low);
    return dragged(start_, drag_, pivot_of(view), from_, solid_point(view, pointer));
}

}  // namespace burl
