#include "app/kept/frames.h"

#include <bit>

#include "app/export/vertices.h"
#include "app/surface/normals.h"
#include "app/surface/tangents.h"

namespace burl {
namespace {

std::uint32_t bits_of(float value) {
    return std::bit_cast<std::uint32_t>(value + 0.0f);  // -0 becomes 0
}

/// The transform from the scene to the part's vertices; the identity where there is none.
Mat4d from_scene(const GltfPartOrigin& part) {
    const Mat3d linear(part.to_scene);
    return glm::determinant(linear) == 0.0 ? Mat4d(1.0) : glm::inverse(part.to_scene);
}

}  // namespace

KeptFrames::KeptFrames(const SceneContent& content)
    : atlas_(content.atlas),
      uvs_(corner_uvs(content.atlas)),
      blocks_(blocks_of_triangles(content.atlas)) {
    const ExportOptions& options = content.options;
    if (!options.normals || !options.normals->tangent_space) return;
    normals_ = corner_normals(content.mesh, options.crease_degrees);
    tangents_ = corner_tangents(content.mesh.positions, content.mesh.triangles, uvs_, normals_);
}

CornerBits KeptFrames::bits(std::size_t corner) const {
    const auto [u, v] = uv(corner);
    CornerBits bits{bits_of(u), bits_of(v), 0, 0, 0, 0};
    if (!has_tangents()) return bits;
    bits[5] = bits_of(tangents_[corner].w);
    if (!splits_normals_) return bits;
    const Vec3f& n = normals_[corner];
    bits[2] = bits_of(n.x), bits[3] = bits_of(n.y), bits[4] = bits_of(n.z);
    return bits;
}

std::array<float, 2> KeptFrames::uv(std::size_t corner) const {
    if (corner == KeptVertices::no_corner) return {0.0f, 0.0f};
    return {float(uvs_[corner].x) + 0.0f, float(uvs_[corner].y) + 0.0f};
}

std::array<float, 4> KeptFrames::block(std::size_t corner) const {
    if (corner == KeptVertices::no_corner) return {0.0f, 0.0f, 1.0f, 1.0f};
    return rectangle_of(atlas_, atlas_.blocks[blocks_[corner / 3]]);
}

Vec3f KeptFrames::normal(std::size_t corner) const {
    return corner == KeptVertices::no_corner ? Vec3f(0.0f, 0.0f, 1.0f) : normals_[corner];
}

Vec4f KeptFrames::tangent(std::size_t corner) const {
    return corner == KeptVertices::no_corner ? Vec4f(1.0f, 0.0f, 0.0f, 1.0f) : tangents_[corner];
}

PartFrames::PartFrames(const KeptFrames& frames, const GltfPartOrigin& part)
    : frames_(frames), from_scene_(from_scene(part)), normal_from_scene_(from_scene_) {}

Vec3f PartFrames::normal(std::size_t corner) const {
    return normal_from_scene_(frames_.normal(corner)) + 0.0f;
}

Vec4f PartFrames::tangent(std::size_t corner) const {
    return placed_tangent(frames_.tangent(corner), normal(corner), Mat3d(from_scene_));
}

}  // namespace burl
