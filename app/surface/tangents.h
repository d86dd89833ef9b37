#pragma once
// Tangents of a mesh with texture coordinates, as glTF 2.0's TANGENT holds them, and the shading
// frames in which normal maps are baked and looked up: positions, normals and tangents per corner
// of a mesh. Recipes' bumps perturb these normals.
#include <span>
#include <vector>

#include "atlas/build/mesh_atlas.h"
#include "atlas/mesh/mesh.h"
#include "atlas/solid/atlas.h"

namespace burl {

/// Per triangle corner (3t+k) a unit vector perpendicular to the normal in the direction of growing
/// u, and w: 1 where cross(normal, tangent) is the image's up (falling v), -1 where the chart is
/// mirrored. Corners that agree in position, texture coordinate (as floats), normal and w share
/// their tangent, the mean over their triangles weighted by the angle each has there (as in
/// MikkTSpace, Mikkelsen 2008), so that the frame is continuous over every edge inside a chart and
/// no vertex has to be split. Where the texture coordinates span no area the tangent is any
/// perpendicular vector. `uvs` and `normals` are per corner, v = 0 at image row 0.
std::vector<Vec4f> corner_tangents(std::span<const Vec3d> positions,
                                   std::span<const Triangle> triangles, std::span<const Vec2d> uvs,
                                   std::span<const Vec3f> normals);

/// The tangent transformed by `linear` and made perpendicular to the transformed unit normal; any
/// perpendicular vector where nothing remains. w changes its sign where `linear` mirrors.
Vec4f placed_tangent(const Vec4f& tangent, const Vec3f& normal, const Mat3d& linear);

/// The atlas's texture coordinates per triangle corner (3t+k), in 0..1.
std::vector<Vec2d> corner_uvs(const Atlas& atlas);

/// The settings that frames of a given atlas depend on.
struct NormalFramesKey {
    SolidSpace space = SolidSpace::unit;
    double crease_degrees = 0.0;
    bool tangents = false;
    bool operator==(const NormalFramesKey&) const = default;
};

/// Arrays for ShadingFrames (procedural/fill/normals.h).
struct NormalFrames {
    NormalFramesKey key{};
    std::vector<Vec3d> positions{};
    std::vector<Vec3f> normals{};   ///< per triangle corner (3t+k), of app/surface/normals.h
    std::vector<Vec4f> tangents{};  ///< per triangle corner, as corner_tangents(); empty for
                                    ///< maps in object space
};

/// The frames of the mesh that `atlas` was built from.
NormalFrames make_normal_frames(const Mesh& mesh, const MeshAtlas& atlas,
                                const NormalFramesKey& key);

}  // namespace burl
