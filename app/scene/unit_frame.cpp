#include "app/scene/unit_frame.h"

namespace burl {

Mat4d unit_frame(const Surface& surface) {
    const Sphere sphere = sphere_around([&](auto visit) {
        for (const Vec3d& p : surface.positions) visit(p);
    });
    Mat4d frame(sphere.radius > 0.0 ? sphere.radius : 1.0);
    frame[3] = Vec4d(sphere.centre, 1.0);
    return frame;
}

std::vector<Mat4d> unit_frames(const Scene& scene) {
    std::vector<Mat4d> frames;
    for (const Surface& surface : scene.surfaces) frames.push_back(unit_frame(surface));
    return frames;
}

}  // namespace burl
