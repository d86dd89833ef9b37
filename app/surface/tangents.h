#pragma once
// Tangents of a mesh with texture coordinates, as glTF 2.0's TANGENT holds them: what a normal map
// is baked in and looked up with.
#include <span>
#include <vector>

#include "atlas/mesh/mesh.h"
#include "atlas/solid/atlas.h"

namespace burl {

/// Per triangle corner (3t+k) a unit vector perpendicular to its normal, towards growing u, and w:
/// 1 where cross(normal, tangent) is the image's up (falling v), -1 where the chart is mirrored.
/// Corners that agree in place, texture coordinate (as floats), normal and w share their tangent,
/// the mean over their triangles weighted by the angle each has there (as in MikkTSpace, Mikkelsen
/// 2008): so the frame is continuous over every edge inside a chart, and no vertex has to be split.
/// Where the texture coordinates span no area, any perpendicular vector. `uvs` and `normals` are
/// per corner, v = 0 at image row 0.
std::vector<Vec4f> corner_tangents(std::span<const Vec3d> positions,
                                   std::span<const Triangle> triangles, std::span<const Vec2d> uvs,
                                   std::span<const Vec3f> normals);

/// A tangent moved with the surface by `linear`, made perpendicular to the moved unit normal.
/// Where nothing of it is left, any perpendicular vector.
Vec4f placed_tangent(const Vec4f& tangent, const Vec3f& normal, const Mat3d& linear);

/// The atlas's texture coordinates, per triangle corner.
std::vector<Vec2d> corner_uvs(const Atlas& atlas);

}  // namespace burl
