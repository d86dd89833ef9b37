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

/// Per joint of the skin, from the mesh as it is stored to the scene. `to_scene` has the nodes'
/// transforms. Throws Error(invalid_file) where matrices are missing.
std::vector<Mat4d> joint_matrices(const tinygltf::Model& model, int skin,
                                  std::span<const Mat4d> to_scene, const std::string& path);

/// Where the joints take the vertices of one primitive.
class VertexSkin {
  public:
    /// Nothing of a primitive that names no joints. `joints` must outlive it. Throws
    /// Error(invalid_file) for joints that the skin does not have, or wrong types.
    VertexSkin(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
               std::span<const Mat4d> joints, const std::string& path, const std::string& where);

    bool empty() const { return influences_.empty(); }

    /// The mean of the joints' matrices by the vertex's weights, whose sum is made 1; of a vertex
    /// without weights its first joint's.
    Mat4d operator[](std::size_t vertex) const;

  private:
    struct Influence {
        std::array<std::size_t, 4> joints{};
        Vec4d weights{0.0};
    };

    std::span<const Mat4d> joints_;
    std::size_t sets_ = 0;               ///< of four joints a vertex
    std::vector<Influence> influences_;  ///< vertex after vertex, set after set
};

}  // namespace burl
