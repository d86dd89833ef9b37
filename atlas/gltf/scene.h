#pragma once
// The meshes that a glTF's default scene draws, and their places.
#include <cstddef>
#include <span>
#include <vector>

#include "atlas/base/vec.h"

namespace tinygltf {
class Model;
}

namespace burl {

/// One mesh of the file with the places where the scene draws it.
struct GltfPlacement {
    int mesh = 0;
    int skin = -1;  ///< skin of its first node; -1: none
    /// The nodes that draw the mesh, in the order of a walk down the scene; only the first one if
    /// the mesh is skinned.
    std::vector<int> nodes;
    /// The affine transform of each of `nodes` to the scene; the identity if the mesh is skinned,
    /// as in its bind pose.
    std::vector<Mat4d> to_scene;
};

/// Transforms from each node to the scene; `local` are the nodes' transforms to their parents.
std::vector<Mat4d> scene_transforms(const tinygltf::Model& model, std::span<const Mat4d> local);

/// The meshes that the scene draws, in the order of their first node. The scene is the default one,
/// the first where none is named, or all root nodes of a file without scenes. A skinned mesh is
/// placed once. `model` comes from load_gltf(), `to_scene` from scene_transforms().
std::vector<GltfPlacement> scene_placements(const tinygltf::Model& model,
                                            std::span<const Mat4d> to_scene);

/// The meshes that the scene draws with the nodes at rest (nodes_at_rest()).
std::vector<GltfPlacement> scene_placements(const tinygltf::Model& model);

}  // namespace burl
