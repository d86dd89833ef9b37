#include "app/gl_map_cache.h"

namespace burl {

namespace {

std::size_t bytes_of(const GlTile& tile) {
    return 2 * sizeof(MapTexel) * std::size_t(tile.size.x) * std::size_t(tile.size.y);
}

bool same(const GlTile& a, const GlTile& b) {
    return a.origin == b.origin && a.size == b.size;
}

}  // namespace

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
        if (one.key == key && same(one.tile, tile)) {
            one.used = true;
            return one.map;
        }
    ++made_;
    auto map = std::make_shared<const Map>(make());
    if (bytes_ + bytes_of(tile) <= budget_) {
        bytes_ += bytes_of(tile);
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
        if (!kept.used) bytes_ -= bytes_of(kept.tile);
        return !kept.used;
    });
    for (auto& kept : maps) kept.used = false;
}

void GlMapCache::drop_unused() {
    drop_unused(lattices_);
    drop_unused(points_);
}

}  // namespace burl
