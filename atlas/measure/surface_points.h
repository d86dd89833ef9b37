#pragma once
// Points spread evenly over a surface by area, for measuring what a viewer sees.
#include <cstdint>
#include <vector>

#include "atlas/solid/atlas.h"

namespace burl {

class MeshAtlas;  // atlas/build/mesh_atlas.h

/// A point of a mesh's surface.
struct SurfacePoint {
    std::uint32_t triangle = 0;
    Vec3d weights{0.0};  ///< barycentric weights, sum 1
};

/// `count` points, one at random in each of `count` equal shares of the surface's area (triangle
/// after triangle); triangles without area get none. Empty for a surface without area.
std::vector<SurfacePoint> area_uniform_points(const Mesh& mesh, std::size_t count,
                                              std::uint64_t seed);

/// Place of the point in the mesh's space.
inline Vec3d position(const Mesh& mesh, const SurfacePoint& p) {
    const Triangle& t = mesh.triangles[p.triangle];
    return p.weights.x * mesh.positions[t[0]] + p.weights.y * mesh.positions[t[1]] +
           p.weights.z * mesh.positions[t[2]];
}

/// Place of the point in the texture, in texels.
inline Vec2d place(const Atlas& atlas, const SurfacePoint& p) {
    const auto& c = atlas.corners[p.triangle];
    return p.weights.x * c[0] + p.weights.y * c[1] + p.weights.z * c[2];
}

/// Unit normal of a triangle; zero for a triangle without area.
Vec3d face_normal(const Mesh& mesh, std::uint32_t triangle);

/// The points, of `input`, as points of atlas.mesh(input) at the same places of the surface, so
/// that atlases that split triangles are judged at the same points as those that do not.
std::vector<SurfacePoint> refined_points(const Mesh& input, const MeshAtlas& atlas,
                                         std::vector<SurfacePoint> points);

}  // namespace burl
