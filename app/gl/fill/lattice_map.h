#pragma once
// Lattice maps (procedural/field/lattice_map.h) as textures, filled by the graphics processor from
// the atlas's spans, or by the host and uploaded: the same bits either way. Shaders that evaluate
// noise read them, so that they need neither float64 nor the atlas's triangles.
#include <memory>
#include <optional>

#include "app/gl/fill/spans.h"
#include "procedural/field/lattice_map.h"

namespace burl {

/// Two RGBA32UI textures.
class GlLatticeMap {
  public:
    explicit GlLatticeMap(GlTarget target) : target_(std::move(target)) {}
    /// Cells along x, y, z and the upper half of the quadric; read with a usampler2D.
    const GlTexture& cells() const { return target_.texture(0); }
    /// Places in the cells along x, y, z and the lower half of the quadric.
    const GlTexture& places() const { return target_.texture(1); }
    GlSize size() const { return target_.size(); }
    /// For reading back.
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
    /// For reading back.
    const GlTarget& target() const { return target_; }

  private:
    GlTarget target_;
};

/// Makes the lattice maps of one atlas in one texture's space. What it keeps, the maps of triangles
/// and, where the graphics processor draws, their spans, serves all streams and all tiles.
class GlLatticeMapper {
  public:
    /// `solid` must outlive it, and `gl`. Throws Error(unsupported) for MapFill::gpu where OpenGL
    /// has no float64. `threads` 0 means all.
    GlLatticeMapper(const GladGLContext& gl, const SolidAtlas& solid,
                    const Affine3& texture_from_atlas, int threads = 0,
                    MapFill fill = MapFill::automatic);
    /// Of `maps`, those of the atlas's triangles in the space wanted, as they are.
    GlLatticeMapper(const GladGLContext& gl, const SolidAtlas& solid, std::vector<TexelMap> maps,
                    int threads = 0, MapFill fill = MapFill::automatic);
    GlLatticeMapper(GlLatticeMapper&&) noexcept;
    ~GlLatticeMapper();

    /// As fill_lattice_map, of the texels of `tile`, which lies in the atlas.
    GlLatticeMap make(const std::optional<LatticeStreamKey>& stream,
                      const std::optional<Quadric>& quadric, const GlTile& tile) const;
    /// As fill_point_map: with `in_lattice` for octaves that no stream serves.
    GlPointMap make_points(const Affine3& map, bool in_lattice, const GlTile& tile) const;
    /// Whether the graphics processor fills them.
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
