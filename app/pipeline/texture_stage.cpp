#include <chrono>
#include <utility>

#include "app/paint/texture.h"
#include "app/pipeline/picture_bands.h"
#include "app/pipeline/stages.h"
#include "app/pipeline/tasks.h"

namespace burl {

namespace {

/// Synthesises the unpainted texture by the context's synthesizer.
void synthesize_elsewhere(StageContext& context, const SolidAtlas& solid, const Recipe& recipe,
                          ImageToFill image, StageCost& cost) {
    context.synthesizer->synthesize(solid, recipe, context.way.threads, image);
    cost.work.texels = texels_of(solid);
}

template <class Pixel>
void paint(StageContext& context, const SolidAtlas& solid, const Recipe& recipe,
           Image<Pixel>& image) {
    if (!has_color_paint(recipe.paint)) return;
    context.records.time(Stage::paint, [&](StageCost& cost) {
        cost.work.texels = paint_over(solid, recipe.paint, context.way.threads, image);
        cost.bytes = bytes_of(image);
        return true;
    });
}

/// The economy of a synthesis of all texels of `solid`, of which the context's meter is told.
Economy begun(const StageContext& context, StageCost& cost, const SolidAtlas& solid,
              const std::stop_token& stop) {
    context.begin(tasks::texture, texels_of(solid));
    return {context.skips, &cost.work, stop, context.meter};
}

/// The masks that the recipe's base colour reads.
MaskImages color_masks(const MaskSource& masks, const SolidAtlas& solid, const Recipe& recipe,
                       const std::stop_token& stop = {}) {
    return masks(solid, recipe.texture, GraphOutput::color, stop);
}

/// The cached unpainted picture, made anew where the recipe or the kind of pixel has changed; null
/// if `stop` was requested first.
template <class Pixel>
const Image<Pixel>* unpainted(StageContext& context, TextureCache& cache, const Recipe& recipe,
                              const MaskSource& masks, std::uint32_t level,
                              const std::stop_token& stop) {
    if (context.skips.allows(Skip::stages))
        if (const Image<Pixel>* image = cache.find<Pixel>(recipe)) {
            context.records.keep(Stage::synthesis);
            return image;
        }
    const bool elsewhere = context.synthesizer && level == 0;
    const MaskImages read =
        elsewhere ? MaskImages() : color_masks(masks, cache.solid(), recipe, stop);
    Image<Pixel>& image = cache.open<Pixel>();
    const bool done = context.records.attempt(Stage::synthesis, [&](StageCost& cost) {
        if (stop.stop_requested()) return false;  // the masks are not whole then
        if (elsewhere)
            synthesize_elsewhere(context, cache.solid(), recipe, &image, cost);
        else
            cache.fill(recipe, context.way, begun(context, cost, cache.solid(), stop), image, read);
        cost.bytes = bytes_of(image);
        return !stop.stop_requested();
    });
    if (!done) return nullptr;
    cache.close(recipe);
    return &image;
}

}  // namespace

/// The caches of a level; level l has 3/4 * 4^-l of the budget, its share of a MIP chain's texels.
TextureStage::Level& TextureStage::level(const StageContext& context, const SolidAtlas& solid,
                                         std::uint32_t number) {
    Level& level = levels_[number];
    const std::size_t finest = context.cache - context.cache / 4;
    if (!level.texture) level.texture.emplace(solid, number < 16 ? finest >> (2 * number) : 0);
    return level;
}

template <class Pixel>
Image<Pixel> TextureStage::run(StageContext& context, const SolidAtlas& solid, const Recipe& recipe,
                               const MaskSource& masks, std::uint32_t level) {
    if (context.cache > 0) return *show<Pixel>(context, solid, recipe, masks, level, {});
    const bool elsewhere = context.synthesizer && level == 0;
    const MaskImages read = elsewhere ? MaskImages() : color_masks(masks, solid, recipe);
    const auto start = std::chrono::steady_clock::now();
    StageCost cost;
    Image<Pixel> image;
    if (elsewhere)
        synthesize_elsewhere(context, solid, recipe, &image, cost);
    else
        image = fill_unpainted<Pixel>(solid, recipe, context.way,
                                      begun(context, cost, solid, context.stop), {}, read);
    cost.bytes = bytes_of(image);
    context.records.add(Stage::synthesis, seconds_since(start), cost);
    paint(context, solid, recipe, image);
    return image;
}

void TextureStage::run_in_bands(StageContext& context, const SolidAtlas& solid,
                                const Recipe& recipe, const MaskSource& masks, const TakeRows& take,
                                std::size_t texels) const {
    using Clock = std::chrono::steady_clock;
    const MaskImages read = color_masks(masks, solid, recipe);
    StageCost cost, paint_cost;
    std::chrono::duration<double> taking{}, painting{};
    const auto start = Clock::now();
    const auto take_rows = [&](std::size_t first, Image<RgbF> rows) {
        const auto filled = Clock::now();
        cost.bytes += bytes_of(rows);
        paint_cost.work.texels += paint_over(solid, recipe.paint, context.way.threads, rows, first);
        const auto painted = Clock::now();
        take(first, std::move(rows));
        painting += painted - filled;
        taking += Clock::now() - painted;
    };
    fill_in_bands(solid, recipe, context.way, begun(context, cost, solid, context.stop), read,
                  texels, take_rows);
    const std::chrono::duration<double> all = Clock::now() - start;
    context.records.add(Stage::synthesis, (all - painting - taking).count(), cost);
    if (!has_color_paint(recipe.paint)) return;
    paint_cost.bytes = cost.bytes;
    context.records.add(Stage::paint, painting.count(), paint_cost);
}

template <class Pixel>
std::vector<Image<Pixel>> TextureStage::run_pictures(StageContext& context, const SolidAtlas& solid,
                                                     const Recipe& recipe, const MaskSource& masks,
                                                     const std::vector<PicturePlan>& plans,
                                                     const std::stop_token& asked) const {
    const std::stop_token& stop = asked.stop_possible() ? asked : context.stop;
    const MaskImages read = masks(solid, recipe.texture, GraphOutput::planes, stop);
    if (stop.stop_requested()) return {};
    return context.records.time(Stage::synthesis, [&](StageCost& cost) {
        std::vector<Image<Pixel>> pictures = synthesize_pictures<Pixel>(
            solid, recipe.texture, plans, texture_from_solid(recipe), recipe.filter,
            context.way.threads, recipe.precision.kind.value_or(PrecisionKind::float32),
            begun(context, cost, solid, stop), read);
        if (stop.stop_requested()) pictures.clear();
        for (const Image<Pixel>& picture : pictures) cost.bytes += bytes_of(picture);
        return pictures;
    });
}

template <class Pixel>
void TextureStage::run_pictures_in_bands(StageContext& context, const SolidAtlas& solid,
                                         const Recipe& recipe, const MaskSource& masks,
                                         const std::vector<PicturePlan>& plans, std::size_t rows,
                                         const TakePictures<Pixel>& take) const {
    const MaskImages read = masks(solid, recipe.texture, GraphOutput::planes, context.stop);
    if (context.stop.stop_requested()) return;
    PictureBands<Pixel> bands(recipe, read, plans);
    context.begin(tasks::texture, texels_of(solid));
    for (std::size_t first = 0; first < solid.size; first += rows) {
        take(first, bands.rows(context, solid, {first, first + rows}));
        if (context.stop.stop_requested()) return;
    }
    bands.record(context);
}

template <class Pixel>
const Image<Pixel>* TextureStage::show(StageContext& context, const SolidAtlas& solid,
                                       const Recipe& recipe, const MaskSource& masks,
                                       std::uint32_t number, const std::stop_token& stop) {
    auto& [texture, layer] = level(context, solid, number);
    const Image<Pixel>* base = unpainted<Pixel>(context, *texture, recipe, masks, number, stop);
    const bool paints = has_color_paint(recipe.paint);
    if (!context.skips.allows(Skip::stages) || !paints) layer.reset();
    if (!base || !paints) return base;
    return context.records.time(Stage::paint, [&](StageCost& cost) {
        if (!layer) layer.emplace(solid, context.way.threads);
        const Image<Pixel>& painted =
            layer->show(*base, texture->number_of_picture(), recipe.paint, cost.work.texels);
        cost.bytes = bytes_of(painted);
        return &painted;
    });
}

void TextureStage::forget_pictures() {
    for (auto& [number, level] : levels_)
        if (level.texture) level.texture->forget_picture();
}

std::size_t TextureStage::cached_bytes() const {
    std::size_t bytes = 0;
    for (const auto& [number, level] : levels_) bytes += level.texture ? level.texture->bytes() : 0;
    return bytes;
}

template Image<Rgb8> TextureStage::run(StageContext&, const SolidAtlas&, const Recipe&,
                                       const MaskSource&, std::uint32_t);
template Image<Rgb16> TextureStage::run(StageContext&, const SolidAtlas&, const Recipe&,
                                        const MaskSource&, std::uint32_t);
template Image<RgbF> TextureStage::run(StageContext&, const SolidAtlas&, const Recipe&,
                                       const MaskSource&, std::uint32_t);
template std::vector<Image<Rgba8>> TextureStage::run_pictures(StageContext&, const SolidAtlas&,
                                                              const Recipe&, const MaskSource&,
                                                              const std::vector<PicturePlan>&,
                                                              const std::stop_token&) const;
template std::vector<Image<Rgba16>> TextureStage::run_pictures(StageContext&, const SolidAtlas&,
                                                               const Recipe&, const MaskSource&,
                                                               const std::vector<PicturePlan>&,
                                                               const std::stop_token&) const;
template std::vector<Image<RgbaF>> TextureStage::run_pictures(StageContext&, const SolidAtlas&,
                                                              const Recipe&, const MaskSource&,
                                                              const std::vector<PicturePlan>&,
                                                              const std::stop_token&) const;
template void TextureStage::run_pictures_in_bands(StageContext&, const SolidAtlas&, const Recipe&,
                                                  const MaskSource&,
                                                  const std::vector<PicturePlan>&, std::size_t,
                                                  const TakePictures<Rgba8>&) const;
template void TextureStage::run_pictures_in_bands(StageContext&, const SolidAtlas&, const Recipe&,
                                                  const MaskSource&,
                                                  const std::vector<PicturePlan>&, std::size_t,
                                                  const TakePictures<Rgba16>&) const;
template void TextureStage::run_pictures_in_bands(StageContext&, const SolidAtlas&, const Recipe&,
                                                  const MaskSource&,
                                                  const std::vector<PicturePlan>&, std::size_t,
                                                  const TakePictures<RgbaF>&) const;
template const Image<Rgb8>* TextureStage::show(StageContext&, const SolidAtlas&, const Recipe&,
                                               const MaskSource&, std::uint32_t,
                                               const std::stop_token&);
template const Image<Rgb16>* TextureStage::show(StageContext&, const SolidAtlas&, const Recipe&,
                                                const MaskSource&, std::uint32_t,
                                                const std::stop_token&);
template const Image<RgbF>* TextureStage::show(StageContext&, const SolidAtlas&, const Recipe&,
                                               const MaskSource&, std::uint32_t,
                                               const std::stop_token&);

}  // namespace burl
