#pragma once
// Transforms of a glTF's nodes at a moment of one of its animations (specification 3.11 and
// appendix C), so that a skinned or moved mesh can be seen in that pose.
#include <string>
#include <vector>

#include "atlas/base/vec.h"

namespace tinygltf {
class Model;
}  // namespace tinygltf

namespace burl {

/// Transforms and morph weights of all nodes at one moment.
struct GltfMotion {
    std::vector<Mat4d> local;  ///< affine transforms to the parent nodes
    /// Each node's weights of morph targets; an empty list means that no target moves it.
    std::vector<std::vector<double>> target_weights;
};

/// The nodes with the transforms that the file stores, and without morph weights.
GltfMotion nodes_at_rest(const tinygltf::Model& model);

/// Name of animation `number` in the file; "animation N" where it has none.
std::string animation_name(const tinygltf::Model& model, std::size_t number);

/// Time of the last key of each animation, in seconds; 0 where it has none. Key times that samplers
/// share are read once.
std::vector<double> animation_ends(const tinygltf::Model& model);

/// The nodes `seconds` into an animation; before the first key and after the last, the values are
/// those of that key. Throws Error(invalid_file) for keys of a wrong type or count; `path` names
/// the file in messages.
GltfMotion motion_at(const tinygltf::Model& model, std::size_t animation, double seconds,
                     const std::string& path);

}  // namespace burl
