#pragma once
// Which meshes a glTF's default scene draws, and where.
#include <cstddef>
#include <span>
#include <vector>

#include "atlas/base/vec.h"

namespace tinygltf {
class Model;
}

namespace burl {

/// One mesh of the file and the places it stands in.
struct GltfPlacement {
    int mesh = 0;
    int skin = -1;           ///< of its first node; -1: none
    std::vector<int> nodes;  ///< in the order of a walk down the scene; of a skinned mesh one
    std::vector<Mat4d>
        to_scene;  ///< one per node; affine; of a skinned mesh 1, as in its bind pose
};

/// From each node to the scene, given each one's transform to its parent.
std::vector<Mat4d> scene_transforms(const tinygltf::Model& model, std::span<const Mat4d> local);

/// Meshes in the order of their first node. The scene is the default one, the first where none is
/// named, or all root nodes of a file without scenes. A skinned mesh is placed once. `model` comes
/// from load_gltf(), `to_scene` from scene_transforms().
std::vector<GltfPlacement> scene_placements(const tinygltf::Model& model,
                                            std::span<const Mat4d> to_scene);

/// With the nodes as the file has them.
std::vector<GltfPlacement> scene_placements(const tinygltf::Model& model);

}  // namespace burl
