#include "app/placed_vertices.h"

#include <utility>

#include "app/tangents.h"

namespace burl {

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
