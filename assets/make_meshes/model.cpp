// Points are shared by their coordinates: patches that meet compute the same ones on both sides.
#include "assets/make_meshes/model.h"

namespace burl {

std::uint32_t Model::point(const Vec3d& position) {
    // Through float32, and -0 becomes 0.
    const Vec3d rounded = Vec3d(Vec3f(position)) + Vec3d(0.0);
    const auto next = static_cast<std::uint32_t>(points_.size());
    const auto [found, added] = index_.try_emplace({rounded.x, rounded.y, rounded.z}, next);
    if (added) points_.push_back(rounded);
    return found->second;
}

void Model::triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    const std::array<std::uint32_t, 3> corners{point(a), point(b), point(c)};
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) return;
    triangles_.push_back(corners);
}

void Model::quad(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
    triangle(a, b, c);
    triangle(a, c, d);
}

}  // namespace burl
