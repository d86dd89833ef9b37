#pragma once
// What moves a glTF's vertices: transforms of its nodes at a moment of one of its animations
// (specification 3.11 and appendix C), and morph targets, other places and normals for a mesh's
// vertices (3.7.2.2).
#include <optional>
#include <string>
#include <vector>

#include "atlas/base/vec.h"

namespace tinygltf {
class Model;
struct Mesh;
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

/// Number of morph targets of the mesh: the largest of its primitives.
std::size_t target_count(const tinygltf::Mesh& mesh);

/// Names of the mesh's morph targets: `extras.targetNames`, else "0", "1", ...
std::vector<std::string> target_names(const tinygltf::Mesh& mesh);

/// Names of the morph targets of all meshes of the file, each once, in the order of their first
/// mesh.
std::vector<std::string> target_names(const tinygltf::Model& model);

/// Index of the mesh's morph target `name`; nothing where it has none.
std::optional<std::size_t> find_target(const tinygltf::Mesh& mesh, const std::string& name);

}  // namespace burl
