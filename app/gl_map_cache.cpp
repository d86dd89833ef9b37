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
    kept_.clear();
    bytes_ = 0;
    mapper_.reset();
    solid_ = nullptr;
}

std::shared_ptr<const GlLatticeMap> GlMapCache::map(const std::optional<LatticeStreamKey>& stream,
                                                    const std::optional<Quadric>& quadric,
                                                    const GlTile& tile) {
    for (Kept& kept : kept_)
        if (kept.stream == stream && kept.quadric == quadric && same(kept.tile, tile)) {
            kept.used = true;
            return kept.map;
        }
    ++made_;
    auto map = std::make_shared<const GlLatticeMap>(mapper_->make(stream, quadric, tile));
    if (bytes_ + bytes_of(tile) <= budget_) {
        bytes_ += bytes_of(tile);
        kept_.push_back({stream, quadric, tile, map});
    }
    return map;
}

void GlMapCache::drop_unused() {
    std::erase_if(kept_, [&](const Kept& kept) {
        if (!kept.used) bytes_ -= bytes_of(kept.tile);
        return !kept.used;
    });
    for (Kept& kept : kept_) kept.used = false;
}

}  // namespace burl
