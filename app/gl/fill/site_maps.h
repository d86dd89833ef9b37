#pragma once
// Site maps and the bases of fixed-point indices (procedural/maps/site_map.h) in arrays that
// shaders read, filled by the host and kept from one synthesis to the next: only frequencies and
// the quadric change them.
#include <memory>
#include <vector>

#include "app/gl/device/target.h"
#include "procedural/maps/site_map.h"

namespace burl {

class GlSiteMaps {
  public:
    using Map = std::shared_ptr<const GlBufferTexture>;

    /// Keeps at most `budget` bytes, 16 a texel and lattice, 4 a texel and quadric.
    GlSiteMaps(const GladGLContext& gl, std::size_t budget) : gl_(&gl), budget_(budget) {}

    /// Maps are of this atlas in this texture's space from now on. Others are dropped.
    void set_atlas(const SolidAtlas& solid, const Affine3& texture_from_atlas, int threads);
    /// Drops everything: the atlas is about to change.
    void forget_atlas();

    /// RGBA32UI: fill_site_map of a tile, its squares row by row.
    Map sites(const LatticeStreamKey& stream, const GlTile& tile);
    /// R32UI: fill_base_map; null where fixed point does not hold the quadric.
    Map bases(const Quadric& quadric, const FixedIndex& index, const GlTile& tile);
    /// Drops the maps that nobody asked for since the last call of this.
    void drop_unused();

    /// Maps made, not found, in all.
    int made() const { return made_; }
    /// The atlas's texel maps in the texture's space.
    std::span<const TexelMap> texel_maps() const { return texel_maps_; }

  private:
    /// What a map depends on besides the tile: a lattice, or a quadric and its fixed point.
    struct Key {
        std::optional<LatticeStreamKey> stream;
        Quadric quadric;
        double lowest = 0.0, highest = 0.0;
        int fraction_bits = 0;
        bool operator==(const Key&) const = default;
    };
    struct Kept {
        Key key;
        GlTile tile;
        Map map;
        std::size_t bytes = 0;
        bool used = true;
    };
    template <class Make>
    Map found(const Key& key, const GlTile& tile, std::size_t texel_bytes, const Make& make);
    template <class Texel, class Fill>
    Map filled(GLenum internal, const GlTile& tile, const Fill& fill);

    const GladGLContext* gl_;
    std::size_t budget_, bytes_ = 0;
    const SolidAtlas* solid_ = nullptr;
    Affine3 texture_from_atlas_;
    std::vector<TexelMap> texel_maps_;
    int threads_ = 0, made_ = 0;
    std::vector<Kept> kept_;
};

}  // namespace burl
