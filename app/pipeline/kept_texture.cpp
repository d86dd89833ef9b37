#include "app/pipeline/kept_texture.h"

namespace burl {

KeptSynthesis& KeptTexture::terms(const Recipe& recipe, Kernel kernel) {
    const Affine3 map = texture_from_solid(recipe);
    number_.reset();
    if (!terms_ || terms_->kernel() != kernel) terms_.emplace(*solid_, map, budget_, kernel);
    terms_->set_map(map);
    return *terms_;
}

KeptGraph& KeptTexture::number() {
    terms_.reset();
    if (!number_) number_.emplace(*solid_, budget_);
    return *number_;
}

template <class Pixel>
void KeptTexture::fill(const Recipe& recipe, const HostWay& way, const Economy& economy,
                       Image<Pixel>& image) {
    const bool keeps =
        budget_ > 0 && economy.skips.allows(Skip::kept_terms) && has_fast_way(recipe, way);
    const Texture* texture = plain_texture(recipe.texture);
    if (keeps && texture)
        terms(recipe, way.kernel).synthesize(*texture, way.threads, image, recipe.filter, economy);
    else if (keeps && KeptGraph::splits(recipe.texture, recipe.filter))
        number().synthesize(recipe.texture, texture_from_solid(recipe), way.threads, image,
                            economy);
    else
        image = fill_unpainted<Pixel>(*solid_, recipe, way, economy);
}

template void KeptTexture::fill(const Recipe&, const HostWay&, const Economy&, Image<Rgb8>&);
template void KeptTexture::fill(const Recipe&, const HostWay&, const Economy&, Image<Rgb16>&);
template void KeptTexture::fill(const Recipe&, const HostWay&, const Economy&, Image<RgbF>&);

}  // namespace burl
