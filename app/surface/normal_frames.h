#pragma once
// The surface that a normal map is made for: places, normals and tangents of a mesh's corners, by
// which recipes' bumps bend the normals.
#include <vector>

#include "atlas/build/mesh_atlas.h"

namespace burl {

/// What frames of a given atlas depend on.
struct NormalFramesKey {
    SolidSpace space = SolidSpace::unit;
    double crease_degrees = 0.0;
    bool tangents = false;
    bool operator==(const NormalFramesKey&) const = default;
};

/// As ShadingFrames (procedural/fill/normals.h) wants them.
struct NormalFrames {
    NormalFramesKey key{};
    std::vector<Vec3d> positions{};
    std::vector<Vec3f> normals{};   ///< of app/surface/normals.h
    std::vector<Vec4f> tangents{};  ///< of app/surface/tangents.h, where asked for
};

/// `mesh` is the one that was laid out as `atlas`.
NormalFrames make_normal_frames(const Mesh& mesh, const MeshAtlas& atlas,
                                const NormalFramesKey& key);

}  // namespace burl
