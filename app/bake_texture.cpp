#include "app/bake_texture.h"

#include <utility>

namespace burl {

namespace {

BakedImage synthesize(Pipeline& pipeline, ImageKind kind) {
    if (kind == ImageKind::rgb16) return pipeline.synthesize<Rgb16>();
    if (kind == ImageKind::rgb_float) return pipeline.synthesize<RgbF>();
    return pipeline.synthesize<Rgb8>();
}

}  // namespace

BakedTexture bake_texture(Pipeline& pipeline, ImageKind kind, const LevelsAsked& levels) {
    if (levels.count == 0) return {synthesize(pipeline, kind)};
    Image<RgbF> texture = pipeline.synthesize<RgbF>();
    std::vector<BakedImage> coarser = bake_levels(pipeline, texture, levels, kind);
    return {convert_to(std::move(texture), kind), std::move(coarser)};
}

}  // namespace burl
