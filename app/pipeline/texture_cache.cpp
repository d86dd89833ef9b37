#include "app/pipeline/texture_cache.h"

namespace burl {

template <class Pixel>
const Image<Pixel>& PaintCache::show(const Image<Pixel>& base, std::uint64_t number,
                                     std::span<const PaintStroke> strokes, std::uint64_t& texels) {
    PaintWork work = layer_.update(strokes_of(strokes, 0));
    auto* shown = std::get_if<Shown<Pixel>>(&shown_);
    if (!shown || number != number_) {
        if (!shown) shown = &shown_.emplace<Shown<Pixel>>();
        shown->image = base;
        work.tiles = layer_.painted_tiles();
        work.texels = work.tiles.size() * PaintTiles::side * PaintTiles::side;
    }
    number_ = number;
    for (const std::uint32_t tile : work.tiles) shown->mixer.mix(layer_, tile, base, shown->image);
    texels += work.texels;
    return shown->image;
}

template const Image<Rgb8>& PaintCache::show(const Image<Rgb8>&, std::uint64_t,
                                             std::span<const PaintStroke>, std::uint64_t&);
template const Image<Rgb16>& PaintCache::show(const Image<Rgb16>&, std::uint64_t,
                                              std::span<const PaintStroke>, std::uint64_t&);
template const Image<RgbF>& PaintCache::show(const Image<RgbF>&, std::uint64_t,
                                             std::span<const PaintStroke>, std::uint64_t&);

CachedSynthesis& TextureCache::terms(const Recipe& recipe, Kernel kernel) {
    const Affine3 map = texture_from_solid(recipe);
    number_.reset();
    if (!terms_ || terms_->kernel() != kernel) terms_.emplace(*solid_, map, budget_, kernel);
    terms_->set_map(map);
    return *terms_;
}

CachedGraph& TextureCache::number() {
    terms_.reset();
    if (!number_) number_.emplace(*solid_, budget_);
    return *number_;
}

template <class Pixel>
void TextureCache::fill(const Recipe& recipe, const HostWay& way, const Economy& economy,
                        Image<Pixel>& image, const MaskImages& masks) {
    const bool keeps =
        budget_ > 0 && economy.skips.allows(Skip::kept_terms) && has_fast_way(recipe, way);
    const Texture* texture = plain_texture(recipe.texture);
    if (keeps && texture)
        terms(recipe, way.kernel).synthesize(*texture, way.threads, image, recipe.filter, economy);
    else if (keeps && CachedGraph::splits(recipe.texture, recipe.filter))
        number().synthesize(recipe.texture, texture_from_solid(recipe), way.threads, image, economy,
                            masks);
    else
        image = fill_unpainted<Pixel>(*solid_, recipe, way, economy, {}, masks);
}

template void TextureCache::fill(const Recipe&, const HostWay&, const Economy&, Image<Rgb8>&,
                                 const MaskImages&);
template void TextureCache::fill(const Recipe&, const HostWay&, const Economy&, Image<Rgb16>&,
                                 const MaskImages&);
template void TextureCache::fill(const Recipe&, const HostWay&, const Economy&, Image<RgbF>&,
                                 const MaskImages&);

}  // namespace burl
