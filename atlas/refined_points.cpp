// A triangle's pieces tile it, so a point lies in the piece in which its least barycentric weight
// is greatest; on a border between pieces rounding picks either.
#include "atlas/refined_points.h"

#include <algorithm>

namespace burl {
namespace {

/// Weights of the triangle a patch vertex lies on: a corner's, or half of two.
Vec3d weights_in(const Triangle& triangle, const VertexOrigin& origin) {
    Vec3d weights(0.0);
    for (int k = 0; k < 3; ++k) {
        const std::uint32_t point = triangle[std::size_t(k)];
        weights[k] = 0.5 * (point == origin.a) + 0.5 * (point == origin.b);
    }
    return weights;
}

/// Pieces of every input triangle, as runs of the refined mesh's triangles.
std::vector<std::uint32_t> first_pieces(const Mesh& input, const PatchAtlas& atlas) {
    const RefinedMesh& refined = atlas.refined;
    std::vector<std::uint32_t> counts(input.triangles.size() + 1, 0);
    std::uint32_t face = 0;
    for (std::uint32_t t = 0; t < refined.patch.size(); ++t) {
        // An unmapped triangle is one piece: that of the face after the one before it.
        if (refined.patch[t] != not_in_mesh) {
            face = atlas.maps.patches[refined.patch[t]].patch.faces[refined.in_patch[t]];
        } else if (t > 0) {
            ++face;
        }
        ++counts[face + 1];
    }
    for (std::size_t i = 1; i < counts.size(); ++i) counts[i] += counts[i - 1];
    return counts;
}

SurfacePoint in_piece(const Mesh& input, const PatchAtlas& atlas, const SurfacePoint& point,
                      std::uint32_t piece) {
    const Patch& patch = atlas.maps.patches[atlas.refined.patch[piece]].patch;
    const Triangle& corners = patch.triangles[atlas.refined.in_patch[piece]];
    Mat3d columns;
    for (int k = 0; k < 3; ++k)
        columns[k] =
            weights_in(input.triangles[point.triangle], patch.origins[corners[std::size_t(k)]]);
    return {piece, glm::inverse(columns) * point.weights};
}

double least(const Vec3d& v) {
    return std::min({v.x, v.y, v.z});
}

}  // namespace

std::vector<SurfacePoint> refined_points(const Mesh& input, const MeshAtlas& atlas,
                                         std::vector<SurfacePoint> points) {
    const PatchAtlas* patches = atlas.patches();
    if (!patches) return points;
    const std::vector<std::uint32_t> first = first_pieces(input, *patches);
    for (SurfacePoint& point : points) {
        const std::uint32_t begin = first[point.triangle], end = first[point.triangle + 1];
        if (patches->refined.patch[begin] == not_in_mesh) {  // whole, and its corners in order
            point.triangle = begin;
            continue;
        }
        SurfacePoint best = in_piece(input, *patches, point, begin);
        for (std::uint32_t piece = begin + 1; piece < end; ++piece) {
            const SurfacePoint next = in_piece(input, *patches, point, piece);
            if (least(next.weights) > least(best.weights)) best = next;
        }
        point = best;
    }
    return points;
}

}  // namespace burl
