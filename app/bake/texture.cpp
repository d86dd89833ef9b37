#include "app/bake/texture.h"

#include <algorithm>
#include <utility>

#include "app/image/convert_image.h"
#include "atlas/build/block_levels.h"

namespace burl {

namespace {

BakedImage synthesize(Pipeline& pipeline, ImageKind kind) {
    if (kind == ImageKind::rgb16) return pipeline.synthesize<Rgb16>();
    if (kind == ImageKind::rgb_float) return pipeline.synthesize<RgbF>();
    return pipeline.synthesize<Rgb8>();
}

Image<Rgb8> converted(const Image<RgbF>& rows, Rgb8) {
    return to_rgb8(rows);
}
Image<Rgb16> converted(const Image<RgbF>& rows, Rgb16) {
    return to_rgb16(rows);
}

/// The texture and its levels, made in bands: the whole float texture is never in memory.
template <class Pixel>
BakedTexture bake_in_bands(Pipeline& pipeline, ImageKind kind, const LevelsAsked& levels) {
    const std::size_t size = pipeline.recipe().atlas.size;
    auto image = Image<Pixel>::unset(size, size);
    const auto take = [&](std::size_t first, const Image<RgbF>& rows) {
        std::ranges::copy(converted(rows, Pixel()).pixels(), &image(0, first));
    };
    std::vector<BakedImage> coarser =
        convert_to(pipeline.levels_in_bands(levels.count, levels.rule, take), kind);
    return {std::move(image), std::move(coarser)};
}

}  // namespace

bool comes_in_bands(Pipeline& pipeline, const LevelsAsked& levels) {
    return pipeline.has_bands() && (levels.count == 0 || halves_in_bands(pipeline.mesh_atlas()));
}

BakedTexture bake_texture(Pipeline& pipeline, ImageKind kind, const LevelsAsked& levels) {
    if (levels.count == 0) return {synthesize(pipeline, kind)};
    const LevelsAsked known{levels_there_are(pipeline, levels, kind), levels.rule};
    const bool wanted = known.count > 0 && kind != ImageKind::rgb_float;
    if (wanted && comes_in_bands(pipeline, known))
        return kind == ImageKind::rgb8 ? bake_in_bands<Rgb8>(pipeline, kind, known)
                                       : bake_in_bands<Rgb16>(pipeline, kind, known);
    Image<RgbF> texture = pipeline.synthesize<RgbF>();
    std::vector<BakedImage> coarser =
        convert_to(pipeline.levels(texture, known.count, known.rule), kind);
    return {convert_to(std::move(texture), kind), std::move(coarser)};
}

}  // namespace burl
