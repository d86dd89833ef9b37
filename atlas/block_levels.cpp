// Above the last pure level, colours times validity and validity are halved side by side and
// divided at the end.
#include "atlas/block_levels.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "atlas/mip_chain.h"

namespace burl {
namespace {

std::uint32_t narrowest_block(const Atlas& atlas) {
    std::uint32_t narrowest = std::numeric_limits<std::uint32_t>::max();
    for (const Block& block : atlas.blocks)
        narrowest = std::min({narrowest, block.width, block.height});
    return std::max(narrowest, 1u);
}

std::uint32_t log2_floor(std::uint32_t n) {
    return static_cast<std::uint32_t>(std::bit_width(n)) - 1;
}

Image<RgbF> times(Image<RgbF> image, const Image<float>& factor) {
    for (std::size_t y = 0; y < image.height(); ++y)
        for (std::size_t x = 0; x < image.width(); ++x) {
            RgbF& p = image(x, y);
            const float f = factor(x, y);
            p = {p.r * f, p.g * f, p.b * f};
        }
    return image;
}

/// Texels that hold no surface at all keep the plain mean.
Image<RgbF> divided(const Image<RgbF>& sums, const Image<float>& weights, Image<RgbF> plain) {
    for (std::size_t y = 0; y < plain.height(); ++y)
        for (std::size_t x = 0; x < plain.width(); ++x) {
            const float weight = weights(x, y);
            const RgbF& sum = sums(x, y);
            if (weight > 0.0f) plain(x, y) = {sum.r / weight, sum.g / weight, sum.b / weight};
        }
    return plain;
}

/// Inner texels' means for the levels after `pure`.
void keep_gutters_out(const PatchAtlas& atlas, const Image<RgbF>& texture, std::uint32_t pure,
                      std::vector<Image<RgbF>>& levels) {
    Image<float> weights = inner_texels(atlas);
    Image<RgbF> sums = times(texture, weights);
    for (std::uint32_t l = 1; l <= levels.size(); ++l) {
        sums = halve(sums);
        weights = halve(weights);
        if (l > pure) levels[l - 1] = divided(sums, weights, std::move(levels[l - 1]));
    }
}

}  // namespace

std::uint32_t last_level(const MeshAtlas& atlas) {
    const AtlasOptions& options = atlas.atlas().options;
    if (options.kind == AtlasKind::patch || options.kind == AtlasKind::quad)
        return log2_floor(options.size);
    return log2_floor(std::max(narrowest_block(atlas.atlas()) / 2, 1u));
}

std::uint32_t last_pure_level(const MeshAtlas& atlas) {
    const Atlas& layout = atlas.atlas();
    if (const PatchAtlas* patches = atlas.patches()) {
        // Blocks lie on multiples of 2g; the texture's own end must lie on one, too.
        const std::uint32_t aligned = 2 * std::max(patches->layout.gutter, 1u);
        return std::min(log2_floor(aligned),
                        static_cast<std::uint32_t>(std::countr_zero(layout.options.size)));
    }
    if (layout.options.kind != AtlasKind::quad) return 0;
    return std::min(log2_floor(narrowest_block(layout)),
                    static_cast<std::uint32_t>(std::countr_zero(layout.options.size)));
}

Image<float> inner_texels(const PatchAtlas& atlas) {
    const std::uint32_t size = atlas.atlas.options.size;
    Image<float> inner(size, size, 0.0f);
    for (const PatchBlock& block : atlas.layout.blocks) {
        const std::uint32_t g = block.gutter, width = block.width - 2 * g;
        for (std::uint32_t y = block.y + g; y < block.y + block.height - g; ++y)
            std::ranges::fill(inner.row(y).subspan(block.x + g, width), 1.0f);
    }
    return inner;
}

std::vector<Image<RgbF>> block_levels(const MeshAtlas& atlas, const Image<RgbF>& texture,
                                      std::uint32_t levels) {
    std::vector<Image<RgbF>> result;
    const std::uint32_t last = std::min(levels, log2_floor(atlas.atlas().options.size));
    for (std::uint32_t l = 1; l <= last; ++l)
        result.push_back(halve(l == 1 ? texture : result.back()));
    const std::uint32_t pure = last_pure_level(atlas);
    if (const PatchAtlas* patches = atlas.patches(); patches && last > pure)
        keep_gutters_out(*patches, texture, pure, result);
    return result;
}

}  // namespace burl
