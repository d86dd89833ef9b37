#pragma once
// The shading frames for which a normal map is baked: positions, normals and tangents per corner of
// a mesh. Recipes' bumps perturb these normals.
#include <vector>

#include "atlas/build/mesh_atlas.h"

namespace burl {

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
    std::vector<Vec4f> tangents{};  ///< per triangle corner, of app/surface/tangents.h; empty for
                                    ///< maps in object space
};

/// The frames of the mesh that `atlas` was built from.
NormalFrames make_normal_frames(const Mesh& mesh, const MeshAtlas& atlas,
                                const NormalFramesKey& key);

}  // namespace burl
