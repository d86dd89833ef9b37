#pragma once
// Skins of a glTF (specification 3.7.3): vertices that follow the joints of a skeleton.
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "atlas/base/vec.h"

namespace tinygltf {
class Model;
struct Primitive;
}  // namespace tinygltf

namespace burl {

/// Matrices of the skin's joints, which take vertices from the mesh as it is stored to the scene.
/// `to_scene` holds the transforms of all nodes to the scene. Throws Error(invalid_file) where
/// matrices are missing.
std::vector<Mat4d> joint_matrices(const tinygltf::Model& model, int skin,
                                  std::span<const Mat4d> to_scene, const std::string& path);

/// The skinning of one primitive: the joints and weights that each of its vertices follows.
class VertexSkin {
  public:
    /// Reads the primitive's joints and weights; empty() where it has none, or `joints` is empty.
    /// `joints` must outlive the object. Throws Error(invalid_file) for joints that the skin does
    /// not have, or wrong types.
    VertexSkin(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
               std::span<const Mat4d> joints, const std::string& path, const std::string& where);

    bool empty() const { return influences_.empty(); }

    /// The mean of the joints' matrices weighted with the vertex's weights, normalised to sum 1;
    /// the first joint's matrix for a vertex without weights.
    Mat4d operator[](std::size_t vertex) const;

  private:
    /// Four joints of a vertex and their weights.
    struct Influence {
        std::array<std::size_t, 4> joints{};
        Vec4d weights{0.0};
    };

    std::span<const Mat4d> joints_;
    std::size_t sets_ = 0;               ///< influences of a vertex
    std::vector<Influence> influences_;  ///< vertex after vertex, set after set
};

}  // namespace burl
