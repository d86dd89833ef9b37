// MIP levels with gutters kept out: above the last pure level, colours times validity and validity
// are halved side by side and divided at the end.
#include "atlas/build/block_levels.h"
#include "atlas/outline/pack.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>

#include "atlas/base/mip_chain.h"
#include "atlas/solid/level.h"

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

float over(float sum, float weight) {
    return sum / weight;
}
Vec4f over(const Vec4f& sum, float weight) {
    return sum / weight;
}
RgbF over(const RgbF& sum, float weight) {
    return {sum.r / weight, sum.g / weight, sum.b / weight};
}
RgbaF over(const RgbaF& sum, float weight) {
    return {sum.r / weight, sum.g / weight, sum.b / weight, sum.a / weight};
}

/// The texelwise quotient of sums and weights; texels of weight 0, which hold no surface at all,
/// keep the plain mean.
template <class T>
Image<T> divided(const Image<T>& sums, const Image<float>& weights, Image<T> plain) {
    for (std::size_t y = 0; y < plain.height(); ++y)
        for (std::size_t x = 0; x < plain.width(); ++x) {
            const float weight = weights(x, y);
            if (weight > 0.0f) plain(x, y) = over(sums(x, y), weight);
        }
    return plain;
}

/// The last level whose texels are gutter or surface and not both; up to it, plain means of texels
/// are means of surface alone.
std::uint32_t last_unmixed_level(const PatchAtlas& atlas) {
    std::uint32_t ends = atlas.atlas.options.size;
    for (const PatchBlock& b : atlas.layout.blocks)
        ends |= (b.x + b.gutter) | (b.y + b.gutter) | (b.x + b.width - b.gutter) |
                (b.y + b.height - b.gutter);
    return static_cast<std::uint32_t>(std::countr_zero(ends));
}

/// Replaces levels first + 1, first + 2, ... as far as they lie above `pure` by means over inner
/// texels only. `image` is level `first`.
template <class T>
void keep_gutters_out(const PatchAtlas& atlas, const Image<T>& image, std::uint32_t first,
                      std::uint32_t pure, std::span<Image<T>> levels) {
    Image<float> weights = inner_texels(atlas, first);
    Image<T> sums;
    for (std::uint32_t l = first + 1; l <= first + levels.size(); ++l) {
        sums = l == first + 1 ? halve_product(image, weights) : halve(sums);
        weights = halve(weights);
        Image<T>& level = levels[l - first - 1];
        if (l > pure) level = divided(sums, weights, std::move(level));
    }
}

/// Texels first, first + 1, ... of an axis, each with the share of it that lies in an interval.
struct Shares {
    std::size_t first = 0;
    std::vector<float> values;
};

/// Shares of a level's texels within the interval [begin, end) of level 0's; a texel of the level
/// is `scale` texels of level 0 wide, and the level has `size` texels a side.
Shares shares_within(std::uint32_t begin, std::uint32_t end, double scale, std::uint32_t size) {
    Shares shares;
    shares.first = std::size_t(double(begin) / scale);
    for (std::size_t i = shares.first; i < size && double(i) * scale < end; ++i) {
        const double low = std::max(double(i) * scale, double(begin));
        const double high = std::min(double(i + 1) * scale, double(end));
        shares.values.push_back(float((high - low) / scale));
    }
    return shares;
}

}  // namespace

std::uint32_t last_level(const MeshAtlas& atlas) {
    const AtlasOptions& options = atlas.atlas().options;
    if (options.kind == AtlasKind::uv)
        return log2_floor(std::min(options.columns(), options.rows()));
    if (!is_strips(options.kind)) return log2_floor(options.size);
    return log2_floor(std::max(narrowest_block(atlas.atlas()) / 2, 1u));
}

std::uint32_t last_pure_level(const MeshAtlas& atlas) {
    const Atlas& layout = atlas.atlas();
    if (const PatchAtlas* patches = atlas.patches()) {
        // Blocks lie on multiples of 2g; the texture's own end must lie on one, too.
        const std::uint32_t aligned = 2 * std::max(patches->layout.gutter, 1u);
        return static_cast<std::uint32_t>(
            std::min(std::countr_zero(aligned), std::countr_zero(layout.options.size)));
    }
    if (layout.options.kind == AtlasKind::chart) {
        const std::uint32_t size = layout.options.size;
        return static_cast<std::uint32_t>(
            std::min(std::countr_zero(outline_cell(size)), std::countr_zero(size)));
    }
    if (layout.options.kind != AtlasKind::quad) return 0;
    return std::min(log2_floor(narrowest_block(layout)),
                    static_cast<std::uint32_t>(std::countr_zero(layout.options.size)));
}

std::uint32_t last_source_level(const MeshAtlas& atlas) {
    if (const PatchAtlas* patches = atlas.patches()) {
        const std::uint32_t pure = last_pure_level(atlas);
        return pure - (patches->layout.gutter > 0 && pure > 0 ? 1 : 0);
    }
    const Atlas& layout = atlas.atlas();
    if (layout.options.kind == AtlasKind::chart) return last_pure_level(atlas);
    const double texels = std::pow(double(layout.options.size), 2.0);
    const std::size_t blocks =
        layout.options.kind == AtlasKind::uv ? layout.chart_count : layout.blocks.size();
    const double block = std::sqrt(texels / double(std::max<std::size_t>(blocks, 1)));
    return log2_floor(std::max(std::uint32_t(block), 1u));
}

bool halves_in_bands(const MeshAtlas& atlas) {
    return !atlas.patches() || last_unmixed_level(*atlas.patches()) > 0;
}

Image<float> inner_texels(const PatchAtlas& atlas, std::uint32_t level) {
    const std::uint32_t size = level_size(atlas.atlas.options.size, level);
    const double scale = double(atlas.atlas.options.size) / size;
    Image<float> inner(size, size, 0.0f);
    for (const PatchBlock& block : atlas.layout.blocks) {
        const std::uint32_t g = block.gutter;
        const Shares x = shares_within(block.x + g, block.x + block.width - g, scale, size);
        const Shares y = shares_within(block.y + g, block.y + block.height - g, scale, size);
        for (std::size_t j = 0; j < y.values.size(); ++j)
            for (std::size_t i = 0; i < x.values.size(); ++i)
                inner(x.first + i, y.first + j) += x.values[i] * y.values[j];
    }
    return inner;
}

template <class T>
std::vector<Image<T>> block_levels(const MeshAtlas& atlas, const Image<T>& image,
                                   std::uint32_t levels, std::uint32_t first) {
    std::vector<Image<T>> result;
    const std::uint32_t last = std::min(levels, log2_floor(atlas.atlas().options.size));
    for (std::uint32_t l = first + 1; l <= last; ++l)
        result.push_back(halve(result.empty() ? image : result.back()));
    const std::uint32_t pure = last_pure_level(atlas);
    if (const PatchAtlas* patches = atlas.patches(); patches && last > std::max(pure, first)) {
        const std::uint32_t start = std::clamp(last_unmixed_level(*patches), first, last);
        const std::size_t known = start - first;
        keep_gutters_out(*patches, known == 0 ? image : result[known - 1], start, pure,
                         std::span(result).subspan(known));
    }
    return result;
}

template std::vector<Image<float>> block_levels(const MeshAtlas&, const Image<float>&,
                                                std::uint32_t, std::uint32_t);
template std::vector<Image<Vec4f>> block_levels(const MeshAtlas&, const Image<Vec4f>&,
                                                std::uint32_t, std::uint32_t);
template std::vector<Image<RgbF>> block_levels(const MeshAtlas&, const Image<RgbF>&, std::uint32_t,
                                               std::uint32_t);
template std::vector<Image<RgbaF>> block_levels(const MeshAtlas&, const Image<RgbaF>&,
                                                std::uint32_t, std::uint32_t);

}  // namespace burl
