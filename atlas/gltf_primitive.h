#pragma once
// One primitive of a glTF mesh as triangles of a soup: its vertices with their attributes, moved to
// the scene, and its triangles, strips or fans.
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "atlas/polygon_soup.h"

namespace tinygltf {
class Model;
struct Primitive;
}  // namespace tinygltf

namespace burl {

/// Appends the primitives of one mesh in one place.
class PrimitiveReader {
  public:
    /// All but `to_scene` must outlive the reader. A mirroring `to_scene` turns the triangles over,
    /// so that their front stays the front. `target`: vertices are where this morph target has
    /// them; normals that it leaves alone are left out, as they are no longer the surface's.
    PrimitiveReader(const tinygltf::Model& model, const std::string& path, const Mat4d& to_scene,
                    PolygonSoup& soup, std::optional<std::size_t> target = std::nullopt);

    /// Appends `primitive`; points and lines are only counted as ignored. `where` names it in
    /// messages. Throws Error(invalid_file) for attributes of a wrong type and for positions that
    /// are not finite.
    void append(const tinygltf::Primitive& primitive, const std::string& where);

    /// Triangles with a repeated index that strips held, and that were left out.
    std::uint64_t stitches() const { return stitches_; }

  private:
    std::uint32_t append_vertices(const tinygltf::Primitive& primitive, const std::string& where);
    void append_positions(const tinygltf::Primitive& primitive, const std::string& where);
    void append_attributes(const tinygltf::Primitive& primitive, std::size_t first,
                           const std::string& where);
    const std::map<std::string, int>* target_of(const tinygltf::Primitive& primitive) const;
    void append_triangles(int mode, const std::vector<std::uint32_t>& indices);
    void push(std::uint32_t a, std::uint32_t b, std::uint32_t c);

    const tinygltf::Model& model_;
    const std::string& path_;
    Mat4d to_scene_;
    Mat3d normal_to_scene_;
    bool mirrored_;
    PolygonSoup& soup_;
    std::optional<std::size_t> target_;
    std::map<std::map<std::string, int>, std::uint32_t> first_point_of_;  ///< by attribute set
    std::uint64_t stitches_ = 0;
};

/// Gives the soup's last points the attributes they lack, where others have them. Call at the end.
void fill_attributes(PolygonSoup& soup);

}  // namespace burl
