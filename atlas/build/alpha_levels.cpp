// Castano bisects for the opacity above which as large a share lies as level 0 shows. That opacity
// is a weighted quantile: sorting finds it exactly, with the gap between texels that it lies in.
#include "atlas/build/alpha_levels.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "atlas/build/block_levels.h"

namespace burl {
namespace {

/// The least number of a block's texels in a level that have a factor of their own: a share is then
/// met to 1/2048.
constexpr std::size_t least_texels = 1024;

/// A rectangle of level 0's texels.
struct Rectangle {
    std::size_t x = 0, y = 0, width = 0, height = 0;
};
/// Rectangles whose texels share a factor.
using Region = std::vector<Rectangle>;

/// Calls visit(x, y) for all texels of a level in the region. Rectangles are as long as the texture
/// or multiples of 2^level.
template <class Visit>
void visit_texels(const Region& region, std::uint32_t level, const Visit& visit) {
    for (const Rectangle& r : region)
        for (std::size_t y = 0; y < std::max<std::size_t>(r.height >> level, 1); ++y)
            for (std::size_t x = 0; x < std::max<std::size_t>(r.width >> level, 1); ++x)
                visit((r.x >> level) + x, (r.y >> level) + y);
}

/// Regions of a level: large blocks on their own and all others together; the whole texture where
/// texels cover several blocks.
std::vector<Region> regions_of(const MeshAtlas& atlas, std::uint32_t level) {
    const std::size_t size = atlas.atlas().options.size;
    if (!atlas.patches() || level > last_pure_level(atlas)) return {{{0, 0, size, size}}};
    std::vector<Region> regions(1);
    for (const PatchBlock& b : atlas.patches()->layout.blocks) {
        const Rectangle block{b.x, b.y, b.width, b.height};
        if ((block.width >> level) * (block.height >> level) < least_texels)
            regions[0].push_back(block);
        else
            regions.push_back({block});
    }
    return regions;
}

/// The share of each of a level's texels that counts: surface of patch atlases, all texels of
/// others.
Image<float> weights_of(const MeshAtlas& atlas, std::uint32_t level, std::size_t size) {
    if (atlas.patches()) return inner_texels(*atlas.patches(), level);
    return {size, size, 1.0f};
}

/// An opacity and the weight of texels that have it.
struct Opacity {
    float value = 0.0f;
    double weight = 0.0;
};

/// Opacities of a region's texels, the greatest first.
std::vector<Opacity> opacities_of(const Image<RgbaF>& image, const Image<float>& weights,
                                  const Region& region, std::uint32_t level) {
    std::vector<Opacity> result;
    visit_texels(region, level, [&](std::size_t x, std::size_t y) {
        if (weights(x, y) > 0.0f) result.push_back({image(x, y).a, double(weights(x, y))});
    });
    std::ranges::sort(result, std::ranges::greater(), &Opacity::value);
    return result;
}

/// The share of a region's surface that a level shows; 0 without surface.
double shown_share(const Image<float>& opacities, const Image<float>& weights, const Region& region,
                   float cutoff) {
    double shown = 0.0, all = 0.0;
    visit_texels(region, 0, [&](std::size_t x, std::size_t y) {
        all += double(weights(x, y));
        if (opacities(x, y) >= cutoff) shown += double(weights(x, y));
    });
    return all > 0.0 ? shown / all : 0.0;
}

/// The opacity between the first `count` of the opacities and the others.
double between(const std::vector<Opacity>& sorted, std::size_t count) {
    if (count == 0) return 2.0 * double(sorted.front().value);
    if (count == sorted.size()) return 0.5 * double(sorted.back().value);
    return 0.5 * (double(sorted[count - 1].value) + double(sorted[count].value));
}

/// The factor of opacities, at which the share of weights with factor * value >= cutoff is nearest
/// to `share`: 1 where that is as near as any.
double factor_for(const std::vector<Opacity>& sorted, double share, float cutoff) {
    double all = 0.0, sum = 0.0;
    for (const Opacity& o : sorted) all += o.weight;
    double unchanged = std::abs(share * all), best = unchanged;
    std::size_t count = 0;
    for (std::size_t i = 0; i < sorted.size() && sorted[i].value > 0.0f; ++i) {
        sum += sorted[i].weight;
        const double error = std::abs(sum - share * all);
        if (sorted[i].value >= cutoff) unchanged = error;
        if (i + 1 < sorted.size() && sorted[i + 1].value == sorted[i].value) continue;
        if (error < best) best = error, count = i + 1;
    }
    return unchanged <= best ? 1.0 : double(cutoff) / between(sorted, count);
}

RgbaF with_opacity_times(const RgbaF& p, double factor) {
    if (!(p.a > 0.0f)) return p;
    const double opacity = std::min(double(p.a) * factor, 1.0), ratio = opacity / double(p.a);
    return {float(p.r * ratio), float(p.g * ratio), float(p.b * ratio), float(opacity)};
}

void scale_level(const MeshAtlas& atlas, const Image<float>& opacities, const Image<float>& weights,
                 float cutoff, std::uint32_t number, Image<RgbaF>& level) {
    const Image<float> level_weights = weights_of(atlas, number, level.width());
    for (const Region& region : regions_of(atlas, number)) {
        const std::vector<Opacity> sorted = opacities_of(level, level_weights, region, number);
        const double share = shown_share(opacities, weights, region, cutoff);
        const double factor = factor_for(sorted, share, cutoff);
        visit_texels(region, number, [&](std::size_t x, std::size_t y) {
            level(x, y) = with_opacity_times(level(x, y), factor);
        });
    }
}

}  // namespace

std::vector<Image<RgbaF>> masked_levels(const MeshAtlas& atlas, const Image<RgbaF>& image,
                                        float cutoff, std::uint32_t levels) {
    std::vector<Image<RgbaF>> result = block_levels(atlas, image, levels);
    scale_masks(atlas, converted<float>(image, [](const RgbaF& p) { return p.a; }), cutoff, result);
    return result;
}

void scale_masks(const MeshAtlas& atlas, const Image<float>& opacities, float cutoff,
                 std::span<Image<RgbaF>> levels) {
    if (!(cutoff > 0.0f && cutoff <= 1.0f)) return;
    const Image<float> weights = weights_of(atlas, 0, opacities.width());
    for (std::uint32_t l = 1; l <= levels.size(); ++l)
        scale_level(atlas, opacities, weights, cutoff, l, levels[l - 1]);
}

}  // namespace burl
