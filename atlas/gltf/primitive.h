#pragma once
// One primitive of a glTF mesh as triangles of a soup: its vertices with their attributes, deformed
// and moved to the scene, and its triangles, strips or fans. A skin (specification 3.7.3) moves
// vertices with the joints of a skeleton.
#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "atlas/base/vec.h"
#include "atlas/mesh/polygon_soup.h"

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

/// Number of triangles that the primitive has by its mode and the number of its indices; 0 for
/// points and lines.
std::uint64_t gltf_triangles(const tinygltf::Model& model, const tinygltf::Primitive& primitive);

/// The placement of one mesh: how its vertices come to the scene.
struct MeshPlace {
    Mat4d to_scene{1.0};
    bool mirrored = false;  ///< whether triangles are turned over, so that fronts stay fronts
    /// Weights of the morph targets, 0 beyond the list's end. Normals of a primitive are left out
    /// where a target with a weight has none for it, as they are no longer the surface's.
    std::vector<double> target_weights{};
    /// Matrices of the skin's joints (joint_matrices()). A primitive with joint indices takes them
    /// instead of `to_scene`.
    std::vector<Mat4d> joints{};
    /// The N of TEXCOORD_N that texture coordinates are read from.
    std::uint32_t uv_set = 0;
};

/// Appends the primitives of one mesh in one place.
class PrimitiveReader {
  public:
    /// `model`, `path` and `soup` must outlive the reader.
    PrimitiveReader(const tinygltf::Model& model, const std::string& path, MeshPlace place,
                    PolygonSoup& soup);

    /// Appends `primitive`; points and lines are only counted as ignored. `where` names it in
    /// messages. Throws Error(invalid_file) for attributes of a wrong type and for positions that
    /// are not finite.
    void append(const tinygltf::Primitive& primitive, const std::string& where);

    /// Number of the soup's point that is vertex 0 of the primitive appended last.
    std::uint32_t first_point() const { return first_point_; }

    /// Number of triangles of strips that were left out because they repeat an index.
    std::uint64_t stitches() const { return stitches_; }

  private:
    using Attributes = std::map<std::string, int>;
    /// The attributes of a morph target and its weight.
    struct WeightedTarget {
        const Attributes* attributes;
        double weight;
        bool operator<(const WeightedTarget& other) const {
            return std::tie(*attributes, weight) < std::tie(*other.attributes, other.weight);
        }
    };
    using Targets = std::vector<WeightedTarget>;
    struct Vertices;

    std::uint32_t append_vertices(const tinygltf::Primitive& primitive, const std::string& where);
    void append_positions(const Vertices& vertices);
    void append_normals(const Vertices& vertices, std::size_t first);
    void append_attributes(const Vertices& vertices, std::size_t first);
    Targets targets_of(const tinygltf::Primitive& primitive) const;
    void append_triangles(int mode, const std::vector<std::uint32_t>& indices);
    void push(std::uint32_t a, std::uint32_t b, std::uint32_t c);

    const tinygltf::Model& model_;
    const std::string& path_;
    MeshPlace place_;
    PolygonSoup& soup_;
    std::map<std::pair<Attributes, Targets>, std::uint32_t> first_point_of_;
    std::uint32_t first_point_ = 0;
    std::uint64_t stitches_ = 0;
};

/// Gives the points read last the attributes that they lack and earlier ones have: default values.
/// To be called when all primitives are appended.
void fill_attributes(PolygonSoup& soup);

}  // namespace burl
