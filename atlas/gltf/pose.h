#pragma once
// Poses that a glTF brings itself: a morph target, a moment of an animation, or a skeleton as its
// nodes stand.
#include <string>
#include <vector>

#include "atlas/gltf/motion.h"

namespace burl {

struct GltfPose {
    GltfMotion nodes;
    std::string target;    ///< a morph target, in full; empty: what the nodes' weights say
    bool skinned = false;  ///< skins follow their joints

    /// Per morph target of the mesh that `node` draws; empty: none moves it.
    std::vector<double> target_weights(const tinygltf::Model& model, int mesh, int node) const;
};

/// What find_pose knows: morph targets; "nodes" where there is a skin; "NAME@SECONDS" for each
/// animation, five moments from its begin to its end. Each name once.
std::vector<std::string> pose_names(const tinygltf::Model& model);

/// Of two that are called the same, the one that pose_names has first. Animations have a pose at
/// every moment. Throws Error(usage) where there is no such pose, invalid_file for a bad animation.
GltfPose find_pose(const tinygltf::Model& model, const std::string& name, const std::string& path);

}  // namespace burl
