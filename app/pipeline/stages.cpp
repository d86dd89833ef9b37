#include "app/pipeline/stages.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "app/paint/mask.h"
#include "app/pipeline/tasks.h"
#include "atlas/base/mip_chain.h"
#include "atlas/base/sharp_level.h"
#include "atlas/build/block_levels.h"
#include "atlas/solid/level.h"
#include "procedural/fill/normals.h"

namespace burl {

namespace {

/// Adds the texels and bytes of levels; the texels of direct levels are counted by their synthesis.
void add_levels(const std::vector<Image<RgbF>>& levels, const LevelRule& rule, StageCost& cost) {
    for (const Image<RgbF>& level : levels) {
        if (!rule.direct) cost.work.texels += level.width() * level.height();
        cost.bytes += bytes_of(level);
    }
}

/// The synthesis of direct levels: never by forward differences, which have no filter.
LevelSynthesis level_synthesis(const StageContext& context, const MaskSource& masks,
                               StageCost& cost) {
    HostWay way = context.way;
    way.forward = false;
    return
        [skips = context.skips, way, &masks, &cost](const SolidAtlas& solid, const Recipe& recipe) {
            return fill_texture<RgbF>(solid, recipe, way, {skips, &cost.work},
                                      masks(solid, recipe.texture, GraphOutput::color, {}));
        };
}

/// Whether a texture or bumps of the recipe take the gradient of a mask: its filter, a node `slope`
/// or the bumps themselves.
bool takes_slopes(const Recipe& recipe, const GraphMask& mask) {
    if (mask.kind == MaskKind::part) return false;  // it has none
    if (recipe.filter.kind != FilterKind::none) return true;
    if (has_slopes(recipe.texture, GraphOutput::planes)) return true;
    const std::vector<GraphMask> bumps = graph_masks(recipe.bump.input);
    return std::ranges::find(bumps, mask) != bumps.end();
}

/// The texels that show triangles of each label.
std::vector<TexelSet> texels_of_labels(const SolidAtlas& solid, const Mesh& mesh,
                                       const MeshAtlas& atlas,
                                       std::span<const std::uint32_t> labels) {
    const std::vector<CornerOrigin> origins = corner_origins(mesh, atlas);
    const TexelOwners owners(solid, atlas.atlas(), OwnerReach::gutters);
    std::vector<TexelSet> sets(std::ranges::max(labels) + std::size_t(1), TexelSet(solid.size));
    for (std::uint32_t y = 0; y < solid.size; ++y)
        for (const Span& span : solid.row(y))
            for (std::uint32_t x = span.x; x < span.x + span.count; ++x)
                sets[labels[origins[3 * owners(x, y, span.map)].a / 3]].insert(x, y);
    return sets;
}

}  // namespace

const Connectivity& ConnectivityStage::run(StageContext& context, const Mesh& mesh,
                                           std::span<const std::uint32_t> labels) {
    if (edges_) {
        context.records.keep(Stage::connectivity);
        return *edges_;
    }
    edges_ = context.records.time(Stage::connectivity, [&](StageCost& cost) {
        Connectivity edges = build_connectivity(mesh);
        cut_between(edges, mesh, labels);
        cost.triangles = mesh.triangles.size();
        cost.bytes = bytes_of(edges.neighbours);
        return edges;
    });
    return *edges_;
}

void ConnectivityStage::release_neighbours() {
    if (edges_) edges_->neighbours = {};
}

const MeshAtlas* LayoutStage::run(StageContext& context, const Mesh& mesh,
                                  const Connectivity& edges, const AtlasOptions& options,
                                  const std::stop_token& stop) {
    if (atlas_) {
        context.records.keep(Stage::layout);
        return &*atlas_;
    }
    context.records.attempt(Stage::layout, [&](StageCost& cost) {
        atlas_ = build_atlas(mesh, edges, options, stop);
        if (!atlas_) return false;
        cost.triangles = atlas_->atlas().corners.size();
        cost.bytes = bytes_of(atlas_->atlas().corners);
        return true;
    });
    return atlas_ ? &*atlas_ : nullptr;
}

const SolidAtlas& SolidStage::run(StageContext& context, const Mesh& mesh, const MeshAtlas& atlas,
                                  SolidSpace space) {
    if (solid_) {
        context.records.keep(Stage::spans);
        return *solid_;
    }
    solid_ = context.records.time(Stage::spans, [&](StageCost& cost) {
        const Affine3 map = solid_from_mesh(mesh, space);
        auto solid = std::make_unique<const SolidAtlas>(
            rasterize(mesh, atlas, map_positions(atlas.mesh(mesh), map)));
        cost.triangles = atlas.atlas().corners.size();
        cost.work.texels = texels_of(*solid);
        cost.bytes = bytes_of(solid->spans) + bytes_of(solid->maps);
        return solid;
    });
    return *solid_;
}

const SolidAtlas& SolidStage::run_level(const SolidAtlas& finest, std::uint32_t level) {
    if (level == 0) return finest;
    std::unique_ptr<const SolidAtlas>& coarse = levels_[level];
    if (!coarse) coarse = std::make_unique<const SolidAtlas>(solid_level(finest, level));
    return *coarse;
}

const SolidAtlas& SolidStage::run_share(const SolidAtlas& finest, const Mesh& mesh,
                                        const MeshAtlas& atlas,
                                        std::span<const std::uint32_t> labels,
                                        std::uint32_t label) {
    if (share_ && share_->first == label) return share_->second;
    if (texels_of_labels_.empty())
        texels_of_labels_ = texels_of_labels(finest, mesh, atlas, labels);
    share_.emplace(label, cut_to(finest, texels_of_labels_[label]));
    return share_->second;
}

void SolidStage::forget() {
    share_.reset();
    texels_of_labels_.clear();
    levels_.clear();
    solid_.reset();
}

MaskImages MaskStage::run(StageContext& context, const Mesh& mesh, const MeshAtlas& atlas,
                          const SolidAtlas& solid, const Recipe& recipe, const TextureGraph& graph,
                          GraphOutput output, const std::stop_token& stop) {
    const std::vector<GraphMask> masks = graph_masks(graph);
    const std::vector<bool> read = masks_read(graph, output);
    MaskImages images(masks.size());
    std::optional<TexelOwners> owners;
    for (std::size_t m = 0; m < masks.size() && !stop.stop_requested(); ++m) {
        const TexelMaskKey key = mask_key(masks[m], recipe, solid.size);
        const bool slopes = takes_slopes(recipe, masks[m]);
        if (read[m]) images[m] = known(context, key, slopes);
        if (!read[m] || images[m]) continue;
        const auto of_the_shape = [&] {
            if (!shape_)
                shape_ = std::make_unique<const MeshShape>(
                    atlas.mesh(mesh), solid_from_mesh(mesh, recipe.solid.space));
            if (!owners) owners.emplace(solid, atlas.atlas(), OwnerReach::gutters);
            return shape_->image(solid, *owners, key, slopes, stop);
        };
        context.begin(tasks::masks);
        const bool done = context.records.attempt(Stage::masks, [&](StageCost& cost) {
            images[m] = std::make_shared<const TexelField>(
                masks[m].kind == MaskKind::paint
                    ? paint_mask(solid, key.strokes, slopes, context.way.threads, stop)
                    : of_the_shape());
            cost.work.texels = texels_of(solid);
            cost.bytes = bytes_of(images[m]->values) + bytes_of(images[m]->slopes);
            return !stop.stop_requested();
        });
        if (done) images_.emplace_back(key, images[m]);
    }
    return images;
}

/// The kept image of a mask; null where there is none, or none with gradients where they are
/// wanted, which is then forgotten.
std::shared_ptr<const TexelField> MaskStage::known(StageContext& context, const TexelMaskKey& key,
                                                   bool slopes) {
    const auto found = std::ranges::find(images_, key, &Known::first);
    if (found == images_.end()) return nullptr;
    if (slopes && found->second->slopes.width() == 0) {
        images_.erase(found);
        return nullptr;
    }
    context.records.keep(Stage::masks);
    return found->second;
}

void MaskStage::keep_those_of(const Recipe& recipe) {
    std::vector<GraphMask> masks = graph_masks(recipe.texture);
    if (!recipe.bump.empty())
        std::ranges::copy(graph_masks(recipe.bump.input), std::back_inserter(masks));
    std::erase_if(images_, [&](const Known& known) {
        return std::ranges::none_of(masks, [&](const GraphMask& mask) {
            return mask_key(mask, recipe, known.first.size) == known.first;
        });
    });
}

void MaskStage::forget() {
    images_.clear();
    shape_.reset();
}

std::vector<Image<RgbF>> LevelStage::run(StageContext& context, const MeshAtlas& atlas,
                                         const SolidAtlas& solid, const Recipe& recipe,
                                         const MaskSource& masks, const Image<RgbF>& texture,
                                         std::uint32_t count, const LevelRule& rule) const {
    context.begin(tasks::levels);
    return context.records.time(Stage::levels, [&](StageCost& cost) {
        std::vector<Image<RgbF>> levels =
            rule.direct           ? direct_levels(atlas, solid, recipe, texture, count, rule,
                                                  level_synthesis(context, masks, cost))
            : context.synthesizer ? context.synthesizer->levels(atlas, texture, count)
                                  : block_levels(atlas, texture, count);
        if (rule.sharp) std::ranges::for_each(levels, sharpen<RgbF>);
        add_levels(levels, rule, cost);
        return levels;
    });
}

std::vector<Image<RgbF>> LevelStage::run_in_bands(StageContext& context, const MeshAtlas& atlas,
                                                  const SolidAtlas& solid, const Recipe& recipe,
                                                  const MaskSource& masks,
                                                  const TextureStage& texture, std::uint32_t count,
                                                  const LevelRule& rule,
                                                  const TakeRows& take) const {
    HalvedRows<RgbF> halved(recipe.atlas.size, recipe.atlas.size);
    const auto halve_rows = [&](std::size_t first, Image<RgbF> rows) {
        halved.add(rows);
        take(first, std::move(rows));
    };
    texture.run_in_bands(context, solid, recipe, masks, halve_rows);
    Image<RgbF> first_level = halved.take();
    const TextureMeans means = [&](std::uint32_t last) {
        std::vector<Image<RgbF>> levels = block_levels(atlas, first_level, last, 1);
        levels.insert(levels.begin(), std::move(first_level));
        return levels;
    };
    context.begin(tasks::levels);
    return context.records.time(Stage::levels, [&](StageCost& cost) {
        std::vector<Image<RgbF>> levels =
            rule.direct ? direct_levels(atlas, solid, recipe, means, count, rule,
                                        level_synthesis(context, masks, cost))
                        : means(count);
        if (rule.sharp) std::ranges::for_each(levels, sharpen<RgbF>);
        add_levels(levels, rule, cost);
        return levels;
    });
}

Image<RgbF> LevelStage::run_one(StageContext& context, const MeshAtlas& atlas,
                                const SolidAtlas& solid, const Recipe& recipe,
                                const MaskSource& masks, std::uint32_t number,
                                const LevelRule& rule) const {
    return context.records.time(Stage::levels, [&](StageCost& cost) {
        Image<RgbF> level =
            direct_level(atlas, solid, recipe, number, rule, level_synthesis(context, masks, cost));
        cost.bytes = bytes_of(level);
        return level;
    });
}

bool NormalStage::Map::is_of(const Recipe& recipe, const NormalFramesKey& key) const {
    return mask_paint == mask_strokes(recipe.paint) && bump == recipe.bump &&
           solid == recipe.solid && filter == recipe.filter &&
           precision == graph_precision(recipe) && frames == key;
}

template <class Pixel>
Image<Pixel> NormalStage::run(StageContext& context, const Mesh& mesh, const MeshAtlas& atlas,
                              const SolidAtlas& solid, const Recipe& recipe,
                              const MaskSource& masks, double crease_degrees, bool tangent_space) {
    const NormalFramesKey key{recipe.solid.space, crease_degrees, tangent_space};
    if (map_ && map_->is_of(recipe, key))
        if (const auto* image = std::get_if<Image<Pixel>>(&map_->image)) {
            context.records.keep(Stage::normals);
            return *image;
        }
    const MaskImages read = masks(solid, recipe.bump.input, GraphOutput::color, {});
    Image<Pixel> map = context.records.time(Stage::normals, [&](StageCost& cost) {
        if (!frames_ || frames_->key != key) frames_ = make_normal_frames(mesh, atlas, key);
        context.begin(tasks::normals);
        Image<Pixel> image = synthesize_normals<Pixel>(
            solid,
            {atlas.mesh(mesh), atlas.atlas(), frames_->positions, frames_->normals,
             frames_->tangents},
            recipe.bump, texture_from_solid(recipe), recipe.filter, context.way.threads,
            graph_precision(recipe), read, {.stop = context.stop, .meter = context.meter});
        cost.work.texels = texels_of(solid);
        cost.bytes = bytes_of(image);
        return image;
    });
    if (context.cache > 0 && context.skips.allows(Skip::stages))
        map_ = Map{recipe.bump,
                   recipe.solid,
                   recipe.filter,
                   graph_precision(recipe),
                   key,
                   mask_strokes(recipe.paint),
                   map};
    else
        frames_.reset();
    return map;
}

void NormalStage::run_in_bands(StageContext& context, const Mesh& mesh, const MeshAtlas& atlas,
                               const SolidAtlas& solid, const Recipe& recipe,
                               const MaskSource& masks, double crease_degrees, bool tangent_space,
                               std::size_t rows, const TakeNormals& take) {
    const NormalFramesKey key{recipe.solid.space, crease_degrees, tangent_space};
    const MaskImages read = masks(solid, recipe.bump.input, GraphOutput::color, {});
    context.records.time(Stage::normals, [&](StageCost& cost) {
        if (!frames_ || frames_->key != key) frames_ = make_normal_frames(mesh, atlas, key);
        context.begin(tasks::normals);
        const auto take_rows = [&](std::size_t first, const Image<RgbF>& band) {
            cost.bytes += bytes_of(band);
            take(first, band);
        };
        synthesize_normals_in_bands(solid,
                                    {atlas.mesh(mesh), atlas.atlas(), frames_->positions,
                                     frames_->normals, frames_->tangents},
                                    recipe.bump, texture_from_solid(recipe), recipe.filter,
                                    context.way.threads, graph_precision(recipe), read,
                                    {.stop = context.stop, .meter = context.meter}, rows,
                                    take_rows);
        cost.work.texels = texels_of(solid);
        return true;
    });
    frames_.reset();
}

template Image<RgbF> NormalStage::run(StageContext&, const Mesh&, const MeshAtlas&,
                                      const SolidAtlas&, const Recipe&, const MaskSource&, double,
                                      bool);
template Image<Rgb8> NormalStage::run(StageContext&, const Mesh&, const MeshAtlas&,
                                      const SolidAtlas&, const Recipe&, const MaskSource&, double,
                                      bool);
template Image<Rgb16> NormalStage::run(StageContext&, const Mesh&, const MeshAtlas&,
                                       const SolidAtlas&, const Recipe&, const MaskSource&, double,
                                       bool);

}  // namespace burl
