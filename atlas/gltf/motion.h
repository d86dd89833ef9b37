#pragma once
// Where the nodes of a glTF stand at a moment of one of its animations (specification 3.11 and
// appendix C), so that a skinned or moved mesh can be seen in that pose.
#include <string>
#include <vector>

#include "atlas/base/vec.h"

namespace tinygltf {
class Model;
}  // namespace tinygltf

namespace burl {

/// Nodes at one moment.
struct GltfMotion {
    std::vector<Mat4d> local;                         ///< per node, to its parent; affine
    std::vector<std::vector<double>> target_weights;  ///< per node and morph target; or empty
};

/// As the file has the nodes; morph targets at 0.
GltfMotion nodes_at_rest(const tinygltf::Model& model);

/// The file's name of animation `number`, else "animation N".
std::string animation_name(const tinygltf::Model& model, std::size_t number);

/// Per animation the moment of its last key in seconds; 0 where it has none. Samplers that share
/// their keys' times have them read once.
std::vector<double> animation_ends(const tinygltf::Model& model);

/// Moments before the first key and after the last are those of the keys. Throws
/// Error(invalid_file) for keys of a wrong type or count; `path` names the file in messages.
GltfMotion motion_at(const tinygltf::Model& model, std::size_t animation, double seconds,
                     const std::string& path);

}  // namespace burl
