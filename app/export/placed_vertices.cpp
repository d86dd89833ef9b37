#include "app/export/placed_vertices.h"

#include <utility>

#include "app/surface/tangents.h"

namespace burl {

namespace {

/// Transforms the morph target: its changes are the differences of both ends as placed.
void place_target(const PartVertices& vertices, const Mat3d& linear,
                  const NormalTransform& normal_transform, PartVertices& out) {
    VertexTarget& target = out.target;
    for (std::size_t i = 0; i < target.positions.size(); ++i) {
        target.positions[i] = Vec3f(linear * Vec3d(target.positions[i])) + 0.0f;
        const Vec3f normal = normal_transform(vertices.normals[i] + target.normals[i]);
        target.normals[i] = normal - out.normals[i] + 0.0f;
        if (target.tangents.empty()) continue;
        const Vec3f tangent = Vec3f(vertices.tangents[i]) + target.tangents[i];
        const Vec4f moved = placed_tangent(Vec4f(tangent, 1.0f), normal, linear);
        target.tangents[i] = Vec3f(moved) - Vec3f(out.tangents[i]) + 0.0f;
    }
}

}  // namespace

Mat4d centred(const Mat4d& placement, const PartVertices& vertices) {
    Mat4d result = placement;
    result[3] = placement * Vec4d(vertices.centre, 1.0);
    for (int c = 0; c < 3; ++c) result[c] *= vertices.scale;
    return result;
}

PartVertices placed(const PartVertices& vertices, const Mat4d& placement) {
    PartVertices out = vertices;
    const Mat3d linear(placement);
    const NormalTransform normal_transform(placement);
    out.centre = Vec3d(placement * Vec4d(vertices.centre, 1.0));
    for (Vec3f& p : out.positions) p = Vec3f(linear * Vec3d(p)) + 0.0f;
    for (Vec3f& n : out.normals) n = normal_transform(n);
    for (std::size_t i = 0; i < out.tangents.size(); ++i)
        out.tangents[i] = placed_tangent(out.tangents[i], out.normals[i], linear);
    place_target(vertices, linear, normal_transform, out);
    for (std::size_t i = 0; normal_transform.mirrors() && i + 2 < out.indices.size(); i += 3) {
        std::swap(out.indices[i + 1], out.indices[i + 2]);
    }
    return out;
}

NodeTransform node_of_placed(const PartVertices& vertices) {
    NodeTransform place;
    place.translation = vertices.centre;
    place.scale = Vec3d(vertices.scale);
    return place;
}

}  // namespace burl
