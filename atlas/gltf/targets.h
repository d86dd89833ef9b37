#pragma once
// Morph targets of a glTF (specification 3.7.2.2): other places and normals for a mesh's vertices.
#include <optional>
#include <string>
#include <vector>

namespace tinygltf {
class Model;
struct Mesh;
}  // namespace tinygltf

namespace burl {

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
