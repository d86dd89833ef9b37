#pragma once
// Lattice maps (procedural/field/lattice_map.h) as textures, drawn by OpenGL from the atlas's
// spans, or filled by the host and uploaded, with the same bits. Shaders that evaluate noise read
// them, so that they need neither float64 nor the atlas's triangles.
#include <memory>
#include <optional>

#include "app/gl/fill/spans.h"
#include "procedural/field/lattice_map.h"

namespace burl {

/// A lattice map as two RGBA32UI textures, which shaders read with a usampler2D.
class GlLatticeMap {
  public:
    explicit GlLatticeMap(GlTarget target) : target_(std::move(target)) {}
    /// The cells along x, y, z and the upper half of the quadric.
    const GlTexture& cells() const { return target_.texture(0); }
    /// The fractions within the cells along x, y, z and the lower half of the quadric.
    const GlTexture& places() const { return target_.texture(1); }
    GlSize size() const { return target_.size(); }
    /// The target with both textures, for reading back.
    const GlTarget& target() const { return target_; }

  private:
    GlTarget target_;
};

/// A point map (procedural/batch/point_map.h) as two RGBA32UI textures.
class GlPointMap {
  public:
    explicit GlPointMap(GlTarget target) : target_(std::move(target)) {}
    const GlTexture& xy() const { return target_.texture(0); }
    const GlTexture& z_owner() const { return target_.texture(1); }
    /// The target with both textures, for reading back.
    const GlTarget& target() const { return target_; }

  private:
    GlTarget target_;
};

/// Makes the lattice maps of one atlas in one texture's space. The triangles' maps and, where
/// OpenGL draws, the spans are kept for all streams and tiles.
class GlLatticeMapper {
  public:
    /// A mapper of `solid` in texture coordinates; `solid` and `gl` must outlive it. 0 threads
    /// means all. Throws Error(unsupported) for MapFill::gpu where OpenGL has no float64.
    GlLatticeMapper(const GladGLContext& gl, const SolidAtlas& solid,
                    const Affine3& texture_from_atlas, int threads = 0,
                    MapFill fill = MapFill::automatic);
    /// A mapper of the triangles' maps in the wanted space. Throws Error(unsupported) for
    /// MapFill::gpu where OpenGL has no float64.
    GlLatticeMapper(const GladGLContext& gl, const SolidAtlas& solid, std::vector<TexelMap> maps,
                    int threads = 0, MapFill fill = MapFill::automatic);
    GlLatticeMapper(GlLatticeMapper&&) noexcept;
    ~GlLatticeMapper();

    /// The lattice map of the texels of `tile`, which lies in the atlas, as fill_lattice_map
    /// computes it.
    GlLatticeMap make(const std::optional<LatticeStreamKey>& stream,
                      const std::optional<Quadric>& quadric, const GlTile& tile) const;
    /// The point map of the texels of `tile`, as fill_point_map computes it; `in_lattice` is for
    /// octaves without a stream kernel.
    GlPointMap make_points(const Affine3& map, bool in_lattice, const GlTile& tile) const;
    /// Whether OpenGL draws the maps.
    bool draws() const { return drawing_ != nullptr; }

  private:
    struct Drawing;
    void draw(const LatticeStreamKey& stream, const Quadric& quadric, const GlTile& tile,
              const GlTarget& target) const;
    void fill(const std::optional<LatticeStreamKey>& stream, const std::optional<Quadric>& quadric,
              const GlTile& tile, const GlTarget& target) const;

    const GladGLContext* gl_;
    const SolidAtlas* solid_;
    std::vector<TexelMap> maps_;
    int threads_;
    std::unique_ptr<Drawing> drawing_;
};

}  // namespace burl
