#pragma once
// Texture coordinates, normals and tangents of a carved mesh's corners, and the same in the space
// of a part's vertices.
#include <array>
#include <cstdint>
#include <vector>

#include "app/export/formats.h"
#include "app/kept/vertices.h"
#include "app/surface/node_transform.h"
#include "atlas/read/gltf_origins.h"

namespace burl {

/// Values that corners (3t+k) have besides the file's attributes, in the space of the carved mesh.
class KeptFrames {
  public:
    /// Tangents are made where the content has a normal map.
    explicit KeptFrames(const SceneContent& content);

    bool has_tangents() const { return !tangents_.empty(); }
    bool has_blocks() const { return !blocks_.empty(); }
    /// Sets whether corners with different normals need vertices of their own.
    void set_splits_normals(bool splits) { splits_normals_ = splits; }

    /// The bits in which corners must agree to share a vertex.
    CornerBits bits(std::size_t corner) const;
    /// Each of a corner; of KeptVertices::no_corner a value that readers accept.
    std::array<float, 2> uv(std::size_t corner) const;
    std::array<float, 4> block(std::size_t corner) const;
    Vec3f normal(std::size_t corner) const;
    Vec4f tangent(std::size_t corner) const;

  private:
    const Atlas& atlas_;
    std::vector<Vec2d> uvs_;
    std::vector<Vec3f> normals_;   ///< empty without tangents
    std::vector<Vec4f> tangents_;  ///< empty without a normal map
    std::vector<std::uint32_t> blocks_;
    bool splits_normals_ = false;
};

/// Normals and tangents in the space of a part's vertices.
class PartFrames {
  public:
    /// `frames` must outlive the object.
    PartFrames(const KeptFrames& frames, const GltfPartOrigin& part);

    Vec3f normal(std::size_t corner) const;
    Vec4f tangent(std::size_t corner) const;

  private:
    const KeptFrames& frames_;
    Mat4d from_scene_;
    NormalTransform normal_from_scene_;
};

}  // namespace burl
