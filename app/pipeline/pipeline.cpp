#include "app/pipeline/pipeline.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "app/paint/texture.h"
#include "atlas/base/mip_chain.h"
#include "atlas/build/block_levels.h"
#include "atlas/solid/level.h"
#include "procedural/fill/normals.h"

namespace burl {

namespace {

/// The number of texels in spans.
std::uint64_t texels_of(const SolidAtlas& solid) {
    std::uint64_t count = 0;
    for (const Span& span : solid.spans) count += span.count;
    return count;
}

template <class Element>
std::uint64_t bytes_of(const std::vector<Element>& elements) {
    return elements.size() * sizeof(Element);
}

template <class Pixel>
std::uint64_t bytes_of(const Image<Pixel>& image) {
    return image.width() * image.height() * sizeof(Pixel);
}

/// Adds the texels and bytes of levels; the texels of direct levels are counted by their synthesis.
void add_levels(const std::vector<Image<RgbF>>& levels, const LevelRule& rule, StageCost& cost) {
    for (const Image<RgbF>& level : levels) {
        if (!rule.direct) cost.work.texels += level.width() * level.height();
        cost.bytes += bytes_of(level);
    }
}

}  // namespace

/// Cache of the latest normal map, with its key.
struct Pipeline::KeptNormals {
    Bump bump;
    SolidOptions solid;
    Filter filter;
    NormalFramesKey frames;
    std::variant<Image<Rgb8>, Image<Rgb16>, Image<RgbF>> image{};

    bool is_of(const Recipe& recipe, const NormalFramesKey& key) const {
        return bump == recipe.bump && solid == recipe.solid && filter == recipe.filter &&
               frames == key;
    }
};

Pipeline::Pipeline(Mesh mesh) : mesh_(std::move(mesh)) {}

void Pipeline::set_recipe(const Recipe& recipe) {
    const bool forgets = !skips_.allows(Skip::stages);
    if (forgets) connectivity_.reset();
    if (forgets || recipe.atlas != recipe_.atlas) {
        atlas_.reset();
        frames_.reset();
    }
    if (!atlas_ || recipe.solid.space != recipe_.solid.space) forget_solid();
    recipe_ = recipe;
    records_.begin_recipe();
}

void Pipeline::set_kernel(Kernel kernel) {
    if (kernel != way_.kernel) forget_pictures();
    way_.kernel = kernel;
}

void Pipeline::set_forward(bool forward) {
    if (forward != way_.forward) forget_pictures();
    way_.forward = forward;
}

void Pipeline::set_synthesizer(std::shared_ptr<TextureSynthesizer> synthesizer) {
    if (synthesizer != synthesizer_) {
        if (synthesizer_) synthesizer_->forget_atlas();
        forget_pictures();
    }
    synthesizer_ = std::move(synthesizer);
}

void Pipeline::set_cache(std::size_t bytes) {
    if (bytes != cache_) levels_.clear(), normals_.reset();
    cache_ = bytes;
}

void Pipeline::forget_solid() {
    if (synthesizer_) synthesizer_->forget_atlas();
    levels_.clear();
    normals_.reset();
    solid_.reset();
}

void Pipeline::forget_pictures() {
    for (auto& [number, level] : levels_)
        if (level.kept) level.kept->forget_picture();
}

std::size_t Pipeline::cached_bytes() const {
    std::size_t bytes = 0;
    for (const auto& [number, level] : levels_) bytes += level.kept ? level.kept->bytes() : 0;
    return bytes;
}

const Connectivity& Pipeline::connectivity() {
    if (connectivity_) {
        records_.keep(Stage::connectivity);
        return *connectivity_;
    }
    connectivity_ = records_.time(Stage::connectivity, [&](StageCost& cost) {
        Connectivity edges = build_connectivity(mesh_);
        cost.triangles = mesh_.triangles.size();
        cost.bytes = bytes_of(edges.neighbours);
        return edges;
    });
    return *connectivity_;
}

bool Pipeline::lay_out(const std::stop_token& stop) {
    if (atlas_) {
        if (records_.keep(Stage::layout)) connectivity();
        return true;
    }
    if (connectivity_ && connectivity_->neighbours.empty()) connectivity_.reset();
    const Connectivity& edges = connectivity();
    return records_.attempt(Stage::layout, [&](StageCost& cost) {
        atlas_ = build_atlas(mesh_, edges, recipe_.atlas, stop);
        if (!atlas_) return false;
        cost.triangles = atlas_->atlas().corners.size();
        cost.bytes = bytes_of(atlas_->atlas().corners);
        return true;
    });
}

const MeshAtlas& Pipeline::mesh_atlas() {
    lay_out({});
    return *atlas_;
}

const SolidAtlas& Pipeline::finest_solid() {
    if (solid_) {
        if (records_.keep(Stage::spans)) mesh_atlas();
        return *solid_;
    }
    const MeshAtlas& layout = mesh_atlas();
    solid_ = records_.time(Stage::spans, [&](StageCost& cost) {
        const Affine3 map = solid_from_mesh(mesh_, recipe_.solid.space);
        auto solid = std::make_unique<const SolidAtlas>(
            rasterize(mesh_, layout, map_positions(layout.mesh(mesh_), map)));
        cost.triangles = layout.atlas().corners.size();
        cost.work.texels = texels_of(*solid);
        cost.bytes = bytes_of(solid->spans) + bytes_of(solid->maps);
        return solid;
    });
    return *solid_;
}

const SolidAtlas& Pipeline::solid(std::uint32_t level) {
    const SolidAtlas& finest = finest_solid();
    if (level == 0) return finest;
    Level& coarse = levels_[level];
    if (!coarse.solid)
        coarse.solid = std::make_unique<const SolidAtlas>(solid_level(finest, level));
    return *coarse.solid;
}

/// The cache of a level; level l has 3/4 * 4^-l of the budget, its share of a MIP chain's texels.
KeptTexture& Pipeline::kept(std::uint32_t number) {
    const SolidAtlas& points = solid(number);
    Level& level = levels_[number];
    const std::size_t budget = number < 16 ? (cache_ - cache_ / 4) >> (2 * number) : 0;
    if (!level.kept) level.kept = std::make_unique<KeptTexture>(points, budget);
    return *level.kept;
}

template <class Pixel>
const Image<Pixel>* Pipeline::unpainted(KeptTexture& texture, std::uint32_t level,
                                        const std::stop_token& stop) {
    if (skips_.allows(Skip::stages))
        if (const Image<Pixel>* image = texture.find<Pixel>(recipe_)) {
            records_.keep(Stage::synthesis);
            return image;
        }
    Image<Pixel>& image = texture.open<Pixel>();
    const bool done = records_.attempt(Stage::synthesis, [&](StageCost& cost) {
        const Economy economy{skips_, &cost.work, stop};
        if (synthesizer_ && level == 0)
            synthesize_elsewhere(texture.solid(), &image, cost);
        else
            texture.fill(recipe_, way_, economy, image);
        cost.bytes = bytes_of(image);
        return !stop.stop_requested();
    });
    if (!done) return nullptr;
    texture.close(recipe_);
    return &image;
}

/// The painted texture is cached until the atlas's solid points are freed.
template <class Pixel>
const Image<Pixel>* Pipeline::picture(std::uint32_t level, const std::stop_token& stop) {
    KeptTexture& texture = kept(level);
    const Image<Pixel>* base = unpainted<Pixel>(texture, level, stop);
    std::unique_ptr<KeptPaint>& layer = levels_[level].paint;
    if (!skips_.allows(Skip::stages) || recipe_.paint.empty()) layer.reset();
    if (!base || recipe_.paint.empty()) return base;
    return records_.time(Stage::paint, [&](StageCost& cost) {
        if (!layer) layer = std::make_unique<KeptPaint>(texture.solid(), way_.threads);
        const Image<Pixel>& painted =
            layer->show(*base, texture.number_of_picture(), recipe_.paint, cost.work.texels);
        cost.bytes = bytes_of(painted);
        return &painted;
    });
}

template <class Pixel>
void Pipeline::paint(const SolidAtlas& points, Image<Pixel>& image) {
    if (recipe_.paint.empty()) return;
    records_.time(Stage::paint, [&](StageCost& cost) {
        cost.work.texels = paint_over(points, recipe_.paint, way_.threads, image);
        cost.bytes = bytes_of(image);
        return true;
    });
}

void Pipeline::synthesize_elsewhere(const SolidAtlas& points, ImageToFill image, StageCost& cost) {
    synthesizer_->synthesize(points, recipe_, way_.threads, image);
    cost.work.texels = texels_of(points);
}

template <class Pixel>
Image<Pixel> Pipeline::synthesize(std::uint32_t level) {
    if (cache_ > 0) return *picture<Pixel>(level);
    const SolidAtlas& points = solid(level);
    Image<Pixel> image;
    records_.time(Stage::synthesis, [&](StageCost& cost) {
        if (synthesizer_ && level == 0)
            synthesize_elsewhere(points, &image, cost);
        else
            image = fill_unpainted<Pixel>(points, recipe_, way_, {skips_, &cost.work});
        cost.bytes = bytes_of(image);
        return true;
    });
    paint(points, image);
    return image;
}

void Pipeline::synthesize_in_bands(const TakeRows& take, std::size_t texels) {
    using Clock = std::chrono::steady_clock;
    const SolidAtlas& points = solid();
    StageCost cost, paint_cost;
    std::chrono::duration<double> taking{}, painting{};
    const auto start = Clock::now();
    const auto take_rows = [&](std::size_t first, Image<RgbF> rows) {
        const auto filled = Clock::now();
        cost.bytes += bytes_of(rows);
        paint_cost.work.texels += paint_over(points, recipe_.paint, way_.threads, rows, first);
        const auto painted = Clock::now();
        take(first, std::move(rows));
        painting += painted - filled;
        taking += Clock::now() - painted;
    };
    fill_in_bands(points, recipe_, way_, {skips_, &cost.work}, texels, take_rows);
    const std::chrono::duration<double> all = Clock::now() - start;
    records_.add(Stage::synthesis, (all - painting - taking).count(), cost);
    if (recipe_.paint.empty()) return;
    paint_cost.bytes = cost.bytes;
    records_.add(Stage::paint, painting.count(), paint_cost);
}

/// Synthesis of direct levels: never by forward differences, which have no filter.
LevelSynthesis Pipeline::level_synthesis(StageCost& cost) const {
    HostWay way = way_;
    way.forward = false;
    return [this, way, &cost](const SolidAtlas& solid, const Recipe& recipe) {
        return fill_texture<RgbF>(solid, recipe, way, {skips_, &cost.work});
    };
}

std::vector<Image<RgbF>> Pipeline::levels(const Image<RgbF>& texture, std::uint32_t count,
                                          const LevelRule& rule) {
    const MeshAtlas& layout = mesh_atlas();
    const SolidAtlas& points = finest_solid();
    return records_.time(Stage::levels, [&](StageCost& cost) {
        std::vector<Image<RgbF>> levels =
            rule.direct    ? direct_levels(layout, points, recipe_, texture, count, rule,
                                           level_synthesis(cost))
            : synthesizer_ ? synthesizer_->levels(layout, texture, count)
                           : block_levels(layout, texture, count);
        add_levels(levels, rule, cost);
        return levels;
    });
}

std::vector<Image<RgbF>> Pipeline::levels_in_bands(std::uint32_t count, const LevelRule& rule,
                                                   const TakeRows& take) {
    const MeshAtlas& layout = mesh_atlas();
    const SolidAtlas& points = finest_solid();
    const std::size_t half = recipe_.atlas.size / 2;
    auto first_level = Image<RgbF>::unset(half, half);
    synthesize_in_bands([&](std::size_t first, Image<RgbF> rows) {
        const Image<RgbF> halved = halve(rows);
        std::ranges::copy(halved.pixels(), &first_level(0, first / 2));
        take(first, std::move(rows));
    });
    const TextureMeans means = [&](std::uint32_t last) {
        std::vector<Image<RgbF>> levels = block_levels(layout, first_level, last, 1);
        levels.insert(levels.begin(), std::move(first_level));
        return levels;
    };
    return records_.time(Stage::levels, [&](StageCost& cost) {
        std::vector<Image<RgbF>> levels =
            rule.direct
                ? direct_levels(layout, points, recipe_, means, count, rule, level_synthesis(cost))
                : means(count);
        add_levels(levels, rule, cost);
        return levels;
    });
}

Image<RgbF> Pipeline::level(std::uint32_t number, const LevelRule& rule) {
    if (!rule.direct) {
        Image<RgbF> texture = synthesize<RgbF>();
        std::vector<Image<RgbF>> means = levels(texture, number);
        return means.empty() ? texture : std::move(means.back());
    }
    const MeshAtlas& layout = mesh_atlas();
    const SolidAtlas& points = finest_solid();
    return records_.time(Stage::levels, [&](StageCost& cost) {
        Image<RgbF> level =
            direct_level(layout, points, recipe_, number, rule, level_synthesis(cost));
        cost.bytes = bytes_of(level);
        return level;
    });
}

const NormalFrames& Pipeline::frames(const NormalFramesKey& key) {
    if (!frames_ || frames_->key != key) frames_ = make_normal_frames(mesh_, mesh_atlas(), key);
    return *frames_;
}

template <class Pixel>
Image<Pixel> Pipeline::normal_map(double crease_degrees, bool tangent_space) {
    const NormalFramesKey key{recipe_.solid.space, crease_degrees, tangent_space};
    const SolidAtlas& points = solid();
    if (normals_ && normals_->is_of(recipe_, key))
        if (const auto* image = std::get_if<Image<Pixel>>(&normals_->image)) {
            records_.keep(Stage::normals);
            return *image;
        }
    Image<Pixel> map = records_.time(Stage::normals, [&](StageCost& cost) {
        const NormalFrames& surface = frames(key);
        Image<Pixel> image = synthesize_normals<Pixel>(
            points, {atlas_mesh(), atlas(), surface.positions, surface.normals, surface.tangents},
            recipe_.bump, texture_from_solid(recipe_), recipe_.filter, way_.threads);
        cost.work.texels = texels_of(points);
        cost.bytes = bytes_of(image);
        return image;
    });
    if (cache_ > 0 && skips_.allows(Skip::stages))
        normals_ = std::make_shared<KeptNormals>(
            KeptNormals{recipe_.bump, recipe_.solid, recipe_.filter, key, map});
    else
        frames_.reset();
    return map;
}

template Image<RgbF> Pipeline::normal_map(double, bool);
template Image<Rgb8> Pipeline::normal_map(double, bool);
template Image<Rgb16> Pipeline::normal_map(double, bool);
template Image<Rgb8> Pipeline::synthesize(std::uint32_t);
template Image<Rgb16> Pipeline::synthesize(std::uint32_t);
template Image<RgbF> Pipeline::synthesize(std::uint32_t);
template const Image<Rgb8>* Pipeline::picture(std::uint32_t, const std::stop_token&);
template const Image<Rgb16>* Pipeline::picture(std::uint32_t, const std::stop_token&);
template const Image<RgbF>* Pipeline::picture(std::uint32_t, const std::stop_token&);

}  // namespace burl
