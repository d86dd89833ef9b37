#include "app/gl/fill/site_maps.h"

#include "app/gl/fill/map_upload.h"
#include "procedural/fill/pieces.h"

namespace burl {

void GlSiteMaps::set_atlas(const SolidAtlas& solid, const Affine3& texture_from_atlas,
                           int threads) {
    threads_ = threads;
    if (solid_ == &solid && texture_from_atlas_ == texture_from_atlas) return;
    forget_atlas();
    texel_maps_ = moved_maps(solid.maps, texture_from_atlas, threads);
    solid_ = &solid;
    texture_from_atlas_ = texture_from_atlas;
}

void GlSiteMaps::forget_atlas() {
    kept_.clear();
    bytes_ = 0;
    texel_maps_ = {};
    solid_ = nullptr;
}

template <class Make>
GlSiteMaps::Map GlSiteMaps::found(const Key& key, const GlTile& tile, std::size_t texel_bytes,
                                  const Make& make) {
    for (Kept& one : kept_)
        if (one.key == key && one.tile == tile) {
            one.used = true;
            return one.map;
        }
    ++made_;
    Map map = make();
    const std::size_t bytes =
        texel_bytes * SiteOrder(std::uint32_t(tile.size.x), std::uint32_t(tile.size.y)).texels();
    if (bytes_ + bytes <= budget_) {
        bytes_ += bytes;
        kept_.push_back({key, tile, map, bytes});
    }
    return map;
}

/// A row of squares at a time, so that what is uploaded still lies in a cache. fill(area) gives
/// its texels, or none: then there is no map.
template <class Texel, class Fill>
GlSiteMaps::Map GlSiteMaps::filled(GLenum internal, const GlTile& tile, const Fill& fill) {
    const SiteOrder order(std::uint32_t(tile.size.x), std::uint32_t(tile.size.y));
    auto map = std::make_shared<GlBufferTexture>(*gl_, internal, order.texels());
    for (std::uint32_t row = 0; row < order.rows; ++row) {
        TexelArea area = area_of(tile);
        area.y += row * SiteOrder::square;
        area.height = std::min(SiteOrder::square, area.height - row * SiteOrder::square);
        const std::optional<std::vector<Texel>> texels = fill(area);
        if (!texels) return nullptr;
        map->set(std::size_t(row) * order.columns * SiteOrder::square_texels * sizeof(Texel),
                 std::as_bytes(std::span(*texels)));
    }
    return map;
}

GlSiteMaps::Map GlSiteMaps::sites(const LatticeStreamKey& stream, const GlTile& tile) {
    Key key;
    key.stream = stream;
    return found(key, tile, sizeof(MapTexel), [&] {
        return filled<MapTexel>(GL_RGBA32UI, tile, [&](const TexelArea& area) {
            return std::optional(fill_site_map(*solid_, texel_maps_, stream, area, threads_));
        });
    });
}

GlSiteMaps::Map GlSiteMaps::bases(const Quadric& quadric, const FixedIndex& index,
                                  const GlTile& tile) {
    const Key key{std::nullopt, quadric, index.lowest, index.highest,
                  index.repeats ? 0 : index.fraction_bits};
    return found(key, tile, sizeof(std::uint32_t), [&] {
        return filled<std::uint32_t>(GL_R32UI, tile, [&](const TexelArea& area) {
            return fill_base_map(*solid_, texel_maps_, quadric, index, area, threads_);
        });
    });
}

void GlSiteMaps::drop_unused() {
    std::erase_if(kept_, [&](const Kept& kept) {
        if (!kept.used) bytes_ -= kept.bytes;
        return !kept.used;
    });
    for (Kept& kept : kept_) kept.used = false;
}

}  // namespace burl
