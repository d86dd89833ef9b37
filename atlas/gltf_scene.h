#pragma once
// Which meshes a glTF's default scene draws, and where.
#include <cstddef>
#include <vector>

#include "atlas/vec.h"

namespace tinygltf {
class Model;
}

namespace burl {

/// One mesh of the file and the places it stands in.
struct GltfPlacement {
    int mesh = 0;
    bool skinned = false;         ///< drawn through a skin: its nodes' own transforms do not count
    std::vector<Mat4d> to_scene;  ///< one per node, in the order of a walk down the scene; affine
};

/// Meshes in the order of their first node. The scene is the default one, the first where none is
/// named, or all root nodes of a file without scenes. A skinned mesh is placed once, as in its bind
/// pose. `model` comes from load_gltf().
std::vector<GltfPlacement> scene_placements(const tinygltf::Model& model);

}  // namespace burl
