#pragma once
// A cache of the lattice maps of an atlas from one synthesis to the next: amplitudes, seeds and
// colours leave them unchanged, and making a map takes longer than a synthesis from it.
#include <memory>
#include <optional>
#include <vector>

#include "app/gl/fill/lattice_map.h"

namespace burl {

/// A cache of lattice maps and point maps, keyed by stream, quadric and tile.
class GlMapCache {
  public:
    /// An empty cache of at most `budget` bytes, 32 per texel of a map.
    GlMapCache(const GladGLContext& gl, std::size_t budget) : gl_(&gl), budget_(budget) {}

    /// Sets the atlas and the texture's space of the following maps. Maps of others are dropped.
    void set_atlas(const SolidAtlas& solid, const Affine3& texture_from_atlas, int threads);
    /// Drops all maps; must be called before the atlas changes.
    void forget_atlas();

    /// The map that GlLatticeMapper::make makes, from the cache where it is there.
    std::shared_ptr<const GlLatticeMap> map(const std::optional<LatticeStreamKey>& stream,
                                            const std::optional<Quadric>& quadric,
                                            const GlTile& tile);
    /// The map that GlLatticeMapper::make_points makes for octaves without a stream kernel, from
    /// the cache where it is there.
    std::shared_ptr<const GlPointMap> points(const Affine3& lattice_from_solid, const GlTile& tile);
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
    Affine3 texture_from_atlas_;
    std::optional<GlLatticeMapper> mapper_;
    std::vector<Kept<LatticeKey, GlLatticeMap>> lattices_;
    std::vector<Kept<Affine3, GlPointMap>> points_;
    int made_ = 0;
};

}  // namespace burl
