#pragma once
// The poses a glTF holds: a morph target, a moment of an animation, or a skeleton as its nodes
// stand.
#include <string>
#include <vector>

#include "atlas/gltf/motion.h"

namespace burl {

/// A pose: the state of the nodes, and a morph target or moving skins.
struct GltfPose {
    GltfMotion nodes;
    std::string target;    ///< morph target of full weight; empty: the nodes' weights
    bool skinned = false;  ///< whether skins follow their joints

    /// Weights of the morph targets of the mesh that `node` draws, 0 beyond the list's end; an
    /// empty list means that no target moves it.
    std::vector<double> target_weights(const tinygltf::Model& model, int mesh, int node) const;
};

/// Names that find_pose() finds: the morph targets' names; "nodes" where the file has a skin;
/// "NAME@SECONDS" for five moments of each animation, evenly from 0 to its end. Each name occurs
/// once.
std::vector<std::string> pose_names(const tinygltf::Model& model);

/// The pose called `name`; where several have that name, the one that pose_names() lists first. An
/// animation has a pose at every moment, listed or not. Throws Error(usage) where there is no such
/// pose, Error(invalid_file) for a bad animation.
GltfPose find_pose(const tinygltf::Model& model, const std::string& name, const std::string& path);

}  // namespace burl
