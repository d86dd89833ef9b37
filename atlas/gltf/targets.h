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

/// Of the primitive that has most.
std::size_t target_count(const tinygltf::Mesh& mesh);

/// What each target of the mesh is called: `extras.targetNames`, else "0", "1", ...
std::vector<std::string> target_names(const tinygltf::Mesh& mesh);

/// Of all meshes of the file, each name once, in the order of their first mesh.
std::vector<std::string> target_names(const tinygltf::Model& model);

/// The number of the mesh's target of this name; nothing where it has none.
std::optional<std::size_t> find_target(const tinygltf::Mesh& mesh, const std::string& name);

}  // namespace burl
