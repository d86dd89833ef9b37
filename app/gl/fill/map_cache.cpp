#include "app/gl/fill/map_cache.h"

namespace burl {

void GlMapCache::set_atlas(const SolidAtlas& solid, const Affine3& texture_from_atlas,
                           int threads) {
    if (mapper_ && solid_ == &solid && texture_from_atlas_ == texture_from_atlas) return;
    forget_atlas();
    mapper_.emplace(*gl_, solid, texture_from_atlas, threads);
    solid_ = &solid;
    texture_from_atlas_ = texture_from_atlas;
}

void GlMapCache::forget_atlas() {
    lattices_.clear();
    points_.clear();
    bytes_ = 0;
    mapper_.reset();
    solid_ = nullptr;
}

template <class Key, class Map, class Make>
std::shared_ptr<const Map> GlMapCache::found(std::vector<Kept<Key, Map>>& kept, const Key& key,
                                             const GlTile& tile, const Make& make) {
    for (auto& one : kept)
        if (one.key == key && one.tile == tile) {
            one.used = true;
            return one.map;
        }
    ++made_;
    auto map = std::make_shared<const Map>(make());
    if (bytes_ + 2 * sizeof(MapTexel) * tile.texels() <= budget_) {
        bytes_ += 2 * sizeof(MapTexel) * tile.texels();
        kept.push_back({key, tile, map});
    }
    return map;
}

std::shared_ptr<const GlLatticeMap> GlMapCache::map(const std::optional<LatticeStreamKey>& stream,
                                                    const std::optional<Quadric>& quadric,
                                                    const GlTile& tile) {
    return found(lattices_, LatticeKey{stream, quadric}, tile,
                 [&] { return mapper_->make(stream, quadric, tile); });
}

std::shared_ptr<const GlPointMap> GlMapCache::points(const Affine3& lattice_from_solid,
                                                     const GlTile& tile) {
    return found(points_, lattice_from_solid, tile,
                 [&] { return mapper_->make_points(lattice_from_solid, true, tile); });
}

template <class Maps>
void GlMapCache::drop_unused(Maps& maps) {
    std::erase_if(maps, [&](const auto& kept) {
        if (!kept.used) bytes_ -= 2 * sizeof(MapTexel) * kept.tile.texels();
        return !kept.used;
    });
    for (auto& kept : maps) kept.used = false;
}

void GlMapCache::drop_unused() {
    drop_unused(lattices_);
    drop_unused(points_);
}

}  // namespace burl
