#pragma once
// The gradient of a number over a triangle by its changes along two edges.
#include <array>

#include "atlas/base/vec.h"

namespace burl {

/// The gradient g in the plane of two edges with g . edge = change for both. Directions in which
/// the edges are much shorter than `least`, a length, count for little: it is (E E^T +
/// least^2)^-1 E change (Tikhonov), so that noise on a sliver makes no cliff. 0 where the edges are
/// parallel and `least` is 0.
inline Vec3d gradient_along(const std::array<Vec3d, 2>& edges, const Vec2d& change, double least) {
    const double xx = glm::dot(edges[0], edges[0]) + least * least;
    const double xy = glm::dot(edges[0], edges[1]);
    const double yy = glm::dot(edges[1], edges[1]) + least * least;
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > 0.0)) return Vec3d(0.0);
    return ((yy * change.x - xy * change.y) * edges[0] +
            (xx * change.y - xy * change.x) * edges[1]) /
           determinant;
}

}  // namespace burl
