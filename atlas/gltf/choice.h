#pragma once
// The primitives of a glTF that a user chooses by the names of meshes, nodes and materials.
#include <string>
#include <vector>

#include "atlas/gltf/scene.h"
#include "atlas/mesh/mesh.h"

namespace burl {

/// Names by which globs find things: their own, or "mesh 3" by their number.
std::string gltf_mesh_name(const tinygltf::Model& model, int mesh);
std::string gltf_node_name(const tinygltf::Model& model, int node);
/// Name of the material of a primitive; "no material" for -1.
std::string gltf_material_name(const tinygltf::Model& model, int material);

/// A choice applied to a file.
class ChosenGltf {
  public:
    /// `model` must outlive the object. Throws Error(usage), with the names that there are, for a
    /// glob that no name matches.
    ChosenGltf(const tinygltf::Model& model, const GltfChoice& choice, const std::string& path);

    /// Whether a primitive of a mesh is read, as far as meshes and materials say.
    bool has(int mesh, std::size_t primitive) const;
    /// Whether nodes are left out.
    bool drops_nodes() const { return !nodes_.empty(); }
    /// The placements without nodes that are not chosen, and without meshes none of whose
    /// primitives is. Throws Error(usage) where none is left of some.
    std::vector<GltfPlacement> of(std::vector<GltfPlacement> placements) const;

  private:
    const tinygltf::Model& model_;
    std::string path_;
    std::vector<bool> nodes_;  ///< whether a node is chosen; empty: all are
    std::vector<std::vector<bool>> primitives_;
};

}  // namespace burl
