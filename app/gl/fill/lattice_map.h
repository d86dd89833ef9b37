#pragma once
// Lattice maps (procedural/field/lattice_map.h) as textures, drawn by OpenGL from the atlas's
// spans, or filled by the host and uploaded, with the same bits. Shaders that evaluate noise read
// them, so that they need neither float64 nor the atlas's triangles.
#include <memory>
#include <optional>
#include <vector>

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
    /// A mapper of `solid` with its triangles' maps in the wanted space; `solid` and `gl` must
    /// outlive it. 0 threads means all. Throws Error(unsupported) for MapFill::gpu where OpenGL has
    /// no float64.
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

/// A cache of the lattice maps and point maps of an atlas, keyed by stream, quadric and tile, from
/// one synthesis to the next: amplitudes, seeds and colours leave them unchanged, and making a map
/// takes longer than a synthesis from it.
class GlMapCache {
  public:
    /// An empty cache of at most `budget` bytes, 32 per texel of a map.
    GlMapCache(const GladGLContext& gl, std::size_t budget) : gl_(&gl), budget_(budget) {}

    /// Sets the atlas and the texture's space, else the atlas's own, of the following maps. Maps of
    /// others are dropped.
    void set_atlas(const SolidAtlas& solid, const std::optional<Affine3>& texture_from_atlas,
                   int threads);
    /// Drops all maps; must be called before the atlas changes.
    void forget_atlas();

    /// The map that GlLatticeMapper::make makes, from the cache where it is there.
    std::shared_ptr<const GlLatticeMap> map(const std::optional<LatticeStreamKey>& stream,
                                            const std::optional<Quadric>& quadric,
                                            const GlTile& tile);
    /// The map that GlLatticeMapper::make_points makes, from the cache where it is there.
    std::shared_ptr<const GlPointMap> points(const Affine3& map, bool in_lattice,
                                             const GlTile& tile);
    /// Drops the maps that were not used since the last call.
    void drop_unused();
    /// The number of maps made so far, rather than found in the cache.
    int made() const { return made_; }

  private:
    struct LatticeKey {
        std::optional<LatticeStreamKey> stream;
        std::optional<Quadric> quadric;
        bool operator==(const LatticeKey&) const = default;
    };
    struct PointKey {
        Affine3 map;
        bool in_lattice = false;
        bool operator==(const PointKey&) const = default;
    };
    template <class Key, class Map>
    struct Kept {
        Key key;
        GlTile tile;
        std::shared_ptr<const Map> map;
        bool used = true;
    };
    template <class Key, class Map, class Make>
    std::shared_ptr<const Map> found(std::vector<Kept<Key, Map>>& kept, const Key& key,
                                     const GlTile& tile, const Make& make);
    template <class Maps>
    void drop_unused(Maps& maps);

    const GladGLContext* gl_;
    std::size_t budget_, bytes_ = 0;
    const SolidAtlas* solid_ = nullptr;
    std::optional<Affine3> texture_from_atlas_;
    std::optional<GlLatticeMapper> mapper_;
    std::vector<Kept<LatticeKey, GlLatticeMap>> lattices_;
    std::vector<Kept<PointKey, GlPointMap>> points_;
    int made_ = 0;
};

}  // namespace burl
