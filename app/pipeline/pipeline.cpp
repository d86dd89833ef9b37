#include "app/pipeline/pipeline.h"

#include <utility>

namespace burl {

/// Forgets what the recipe's change makes invalid, before its successors take memory.
void Pipeline::set_recipe(const Recipe& recipe) {
    const bool forgets = !context_.skips.allows(Skip::stages);
    const bool new_layout =
        forgets || recipe.atlas != recipe_.atlas || !stages_.layout.has_result();
    if (new_layout || recipe.solid.space != recipe_.solid.space) forget_solid();
    if (new_layout) {
        stages_.normals.forget_frames();
        stages_.layout.forget();
        if (forgets || stages_.connectivity.is_released()) stages_.connectivity.forget();
    }
    recipe_ = recipe;
    stages_.masks.keep_those_of(recipe);
    context_.records.begin_recipe();
}

void Pipeline::set_labels(std::vector<std::uint32_t> labels) {
    show_label({});  // a bake that failed may have left one
    if (labels == labels_) return;
    labels_ = std::move(labels);
    forget_solid();
    stages_.normals.forget_frames();
    stages_.layout.forget();
    stages_.connectivity.forget();
}

void Pipeline::show_label(std::optional<std::uint32_t> label) {
    if (label == label_) return;
    label_ = label;
    if (context_.synthesizer) context_.synthesizer->forget_atlas();
    stages_.texture.forget();
    stages_.normals.forget();
    stages_.masks.forget_images();
}

void Pipeline::set_kernel(Kernel kernel) {
    if (kernel != context_.way.kernel) stages_.texture.forget_pictures();
    context_.way.kernel = kernel;
}

void Pipeline::set_forward(bool forward) {
    if (forward != context_.way.forward) stages_.texture.forget_pictures();
    context_.way.forward = forward;
}

void Pipeline::set_synthesizer(std::shared_ptr<TextureSynthesizer> synthesizer) {
    if (synthesizer != context_.synthesizer) {
        if (context_.synthesizer) context_.synthesizer->forget_atlas();
        stages_.texture.forget_pictures();
    }
    context_.synthesizer = std::move(synthesizer);
}

void Pipeline::set_cache(std::size_t bytes) {
    if (bytes != context_.cache) {
        stages_.texture.forget();
        stages_.normals.forget();
    }
    context_.cache = bytes;
}

void Pipeline::forget_solid() {
    if (context_.synthesizer) context_.synthesizer->forget_atlas();
    stages_.texture.forget();
    stages_.normals.forget();
    stages_.masks.forget();
    stages_.solid.forget();
}

bool Pipeline::lay_out(const std::stop_token& stop) {
    return stages_.layout.run(context_, mesh_, connectivity(), recipe_.atlas, stop) != nullptr;
}

const MeshAtlas& Pipeline::mesh_atlas() {
    return *stages_.layout.run(context_, mesh_, connectivity(), recipe_.atlas);
}

const SolidAtlas& Pipeline::solid(std::uint32_t level) {
    const SolidAtlas& finest =
        stages_.solid.run(context_, mesh_, mesh_atlas(), recipe_.solid.space);
    if (label_ && level == 0)
        return stages_.solid.run_share(finest, mesh_, mesh_atlas(), labels_, *label_);
    return stages_.solid.run_level(finest, level);
}

MaskSource Pipeline::masks() {
    return [this](const SolidAtlas& solid, const TextureGraph& graph, GraphOutput output,
                  const std::stop_token& stop) {
        return stages_.masks.run(context_, mesh_, mesh_atlas(), solid, recipe_, graph, output,
                                 stop);
    };
}

std::vector<Image<RgbF>> Pipeline::levels(const Image<RgbF>& texture, std::uint32_t count,
                                          const LevelRule& rule) {
    const SolidAtlas& points = solid();
    return stages_.levels.run(context_, mesh_atlas(), points, recipe_, masks(), texture, count,
                              rule);
}

std::vector<Image<RgbF>> Pipeline::levels_in_bands(std::uint32_t count, const LevelRule& rule,
                                                   const TakeRows& take) {
    const SolidAtlas& points = solid();
    return stages_.levels.run_in_bands(context_, mesh_atlas(), points, recipe_, masks(),
                                       stages_.texture, count, rule, take);
}

Image<RgbF> Pipeline::level(std::uint32_t number, const LevelRule& rule) {
    if (!rule.direct) {
        Image<RgbF> texture = synthesize<RgbF>();
        std::vector<Image<RgbF>> means = levels(texture, number, rule);
        return means.empty() ? texture : std::move(means.back());
    }
    const SolidAtlas& points = solid();
    return stages_.levels.run_one(context_, mesh_atlas(), points, recipe_, masks(), number, rule);
}

}  // namespace burl
