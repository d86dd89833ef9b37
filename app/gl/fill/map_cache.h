#pragma once
// The lattice maps of the textures of one atlas, kept from one synthesis to the next: amplitudes,
// seeds and colours leave them as they are, and making one takes longer than a synthesis from it.
#include <memory>
#include <optional>
#include <vector>

#include "app/gl/fill/lattice_map.h"

namespace burl {

class GlMapCache {
  public:
    /// Keeps at most `budget` bytes of maps, 32 a texel.
    GlMapCache(const GladGLContext& gl, std::size_t budget) : gl_(&gl), budget_(budget) {}

    /// Maps are of this atlas in this texture's space from now on. Others are dropped.
    void set_atlas(const SolidAtlas& solid, const Affine3& texture_from_atlas, int threads);
    /// Drops everything: the atlas is about to change.
    void forget_atlas();

    /// As GlLatticeMapper::make, or the same map as before.
    std::shared_ptr<const GlLatticeMap> map(const std::optional<LatticeStreamKey>& stream,
                                            const std::optional<Quadric>& quadric,
                                            const GlTile& tile);
    /// As GlLatticeMapper::make_points for octaves that no stream serves, or the same as before.
    std::shared_ptr<const GlPointMap> points(const Affine3& lattice_from_solid, const GlTile& tile);
    /// Drops the maps that nobody asked for since the last call of this.
    void drop_unused();
    /// Maps made, not found, in all.
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
