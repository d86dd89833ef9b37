#pragma once
// One primitive of a glTF mesh as triangles of a soup: its vertices with their attributes, deformed
// and moved to the scene, and its triangles, strips or fans.
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "atlas/gltf/skin.h"
#include "atlas/mesh/polygon_soup.h"

namespace tinygltf {
class Model;
struct Primitive;
}  // namespace tinygltf

namespace burl {

/// Where vertices of one mesh in one place are.
struct MeshPlace {
    Mat4d to_scene{1.0};
    bool mirrored = false;  ///< triangles are turned over, so that their front stays the front
    /// Per morph target, those left out are 0. Normals that a target leaves alone are left out, as
    /// they are no longer the surface's.
    std::vector<double> target_weights{};
    std::vector<Mat4d> joints{};  ///< of its skin (joint_matrices), then `to_scene` does not count
};

/// Appends the primitives of one mesh in one place.
class PrimitiveReader {
  public:
    /// All but `place` must outlive the reader.
    PrimitiveReader(const tinygltf::Model& model, const std::string& path, MeshPlace place,
                    PolygonSoup& soup);

    /// Appends `primitive`; points and lines are only counted as ignored. `where` names it in
    /// messages. Throws Error(invalid_file) for attributes of a wrong type and for positions that
    /// are not finite.
    void append(const tinygltf::Primitive& primitive, const std::string& where);

    /// Triangles with a repeated index that strips held, and that were left out.
    std::uint64_t stitches() const { return stitches_; }

  private:
    using Attributes = std::map<std::string, int>;
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
    std::uint64_t stitches_ = 0;
};

/// Gives the soup's last points the attributes they lack, where others have them. Call at the end.
void fill_attributes(PolygonSoup& soup);

}  // namespace burl
