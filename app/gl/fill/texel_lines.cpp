#include "app/gl/fill/texel_lines.h"

#include <algorithm>

#include "app/gl/fill/map_upload.h"
#include "procedural/maps/point_map.h"

namespace burl {

void GlTexelLines::set_atlas(const SolidAtlas& solid, std::span<const TexelMap> maps, int threads) {
    static_assert(sizeof(TexelMap) % sizeof(MapTexel) == 0);
    maps_.emplace(*gl_, GLenum(GL_RGBA32UI), std::as_bytes(maps));
    spans_.clear();
    solid_ = &solid;
    threads_ = threads;
}

void GlTexelLines::set_tile(const GlTile& tile) {
    const auto known = std::ranges::find(spans_, tile, &Spans::tile);
    if (known != spans_.end()) {
        std::rotate(known, known + 1, spans_.end());
        return;
    }
    std::size_t bytes = 0;
    for (const Spans& spans : spans_) bytes += sizeof(MapTexel) * spans.tile.texels();
    if (!spans_.empty() && bytes >= budget_) spans_.pop_back();
    const Image<MapTexel> texels = fill_span_map(*solid_, area_of(tile), threads_);
    spans_.push_back(
        {tile, make_texture(*gl_, GL_RGBA32UI, tile.size, std::as_bytes(texels.pixels()))});
}

void GlTexelLines::bind(const GlProgram& program, int first_unit) const {
    bind_texture(*gl_, first_unit, spans_.back().texture);
    maps_->bind(first_unit + 1);
    program.set("span_map", first_unit);
    program.set("texel_maps", first_unit + 1);
    program.set("tile_origin", spans_.back().tile.origin);
}

}  // namespace burl
