#include "app/gl/draw/lazy_picture.h"

#include <algorithm>
#include <utility>

#include "app/base/stopwatch.h"
#include "app/gl/draw/view_pictures.h"
#include "app/gl/draw/view_scene.h"
#include "atlas/base/error.h"
#include "atlas/build/block_levels.h"
#include "atlas/solid/level.h"
#include "atlas/solid/texel_set.h"
#include "procedural/batch/row_tasks.h"
#include "procedural/color/srgb.h"

namespace burl {

namespace {

/// The coarsest level that the view reads of those that a bake writes.
std::uint32_t levels_read(const MeshAtlas& atlas, const ViewTexels& view) {
    std::uint32_t level = std::min(last_level(atlas), std::uint32_t(view.levels.size()) - 1);
    while (level > 0 && view.levels[level].count() == 0) --level;
    return level;
}

/// The image as to_rgb8() (convert_image.h) encodes it, in the texels that are read; black
/// elsewhere.
Image<Rgb8> encoded(const Image<RgbF>& linear, const TexelSet& read, int threads) {
    const SrgbEncoder<std::uint8_t> encode;
    Image<Rgb8> image(linear.width(), linear.height());
    for_row_ranges(linear.height(), 8192, threads, [&](const RowRange& rows) {
        for (std::size_t y = rows.begin(); y != rows.end(); ++y)
            read.for_each_run(std::uint32_t(y), {0, read.size()},
                              [&](std::uint32_t first, std::uint32_t last) {
                                  for (std::uint32_t x = first; x < last; ++x) {
                                      const RgbF& p = linear(x, y);
                                      image(x, y) = {encode(double(p.r)), encode(double(p.g)),
                                                     encode(double(p.b))};
                                  }
                              });
    });
    return image;
}

/// Levels 1 to `count`; direct ones are synthesised only in `part`.
std::vector<Image<RgbF>> levels_of(const ViewSource& source, const std::vector<TexelSet>& part,
                                   const Image<RgbF>& texture, std::uint32_t count,
                                   const HostWay& way, const Economy& economy) {
    if (!source.rule.direct) return block_levels(source.layout, texture, count);
    const auto fill = [&](const SolidAtlas& level, const Recipe& recipe) {
        const auto texels = std::ranges::find(part, level.size, &TexelSet::size);
        return fill_texture<RgbF>(cut_to(level, *texels), recipe, way, economy,
                                  source.color_masks(level));
    };
    return direct_levels(source.layout, source.solid, source.recipe, texture, count, source.rule,
                         fill);
}

void insert_all(TexelSet& texels) {
    for (std::uint32_t y = 0; y < texels.size(); ++y) texels.insert({0, texels.size()}, y);
}

}  // namespace

std::uint32_t ViewSource::source(std::uint32_t level) const {
    if (!rule.direct || level > last_level(layout)) return 0;
    return source_level(layout, rule, level);
}

MaskImages ViewSource::color_masks(const SolidAtlas& level) const {
    return masks ? masks(level, recipe.texture, GraphOutput::color, {}) : MaskImages();
}

SolidAtlas ViewSource::level(std::uint32_t number) const {
    return number == 0 ? solid : solid_level(solid, number);
}

std::vector<TexelSet> view_part(const ViewSource& source, const ViewTexels& view,
                                std::uint32_t cell) {
    std::vector<TexelSet> part =
        view.beneath([&](std::uint32_t level) { return source.source(level); });
    for (TexelSet& texels : part) texels = texels.whole_cells(cell);
    return part;
}

std::vector<TexelSet> whole_part(const ViewSource& source) {
    ViewTexels all(source.solid.size);
    for (TexelSet& level : all.levels) insert_all(level);
    return view_part(source, all, 1);
}

std::uint64_t count_texels(const ViewSource& source, const std::vector<TexelSet>& part) {
    std::uint64_t count = 0;
    for (std::uint32_t l = 0; l < part.size(); ++l)
        if (part[l].count() > 0) count += texel_count(cut_to(source.level(l), part[l]));
    return count;
}

SceneTexture view_texture(const ViewSource& source, const std::vector<TexelSet>& part,
                          const ViewTexels& view, TextureFilter filter, const HostWay& way,
                          const Economy& economy) {
    const SolidAtlas finest = cut_to(source.solid, part[0]);
    const MaskImages masks = source.color_masks(source.solid);
    SceneTexture texture;
    if (filter != TextureFilter::mip) {
        texture.image = fill_texture<Rgb8>(finest, source.recipe, way, economy, masks);
        return texture;
    }
    const auto linear = fill_texture<RgbF>(finest, source.recipe, way, economy, masks);
    texture.image = encoded(linear, part[0], way.threads);
    const std::uint32_t count = levels_read(source.layout, view);
    for (const Image<RgbF>& level : levels_of(source, part, linear, count, way, economy))
        texture.levels.push_back(
            encoded(level, view.levels[texture.levels.size() + 1], way.threads));
    return texture;
}

LazyPicture render_lazily(GlContext& context, Pipeline& pipeline, const View& view,
                          const LazyOptions& options) {
    context.make_current();
    LazyPicture result;
    Scene scene = baked_scene(pipeline, options.crease_degrees, options.pose);
    ViewPictures pictures(pipeline, scene, options);
    const ViewSource& source = pictures.source();
    const int colors = baked_material(scene).texture;
    const Camera camera = orbit_camera(view, bounding_sphere(scene), options.picture.size);
    GlScene drawn(context.gl(), scene, options.filter);
    const TextureLookup lookup = lookup_of(scene, colors, options.filter, source.solid.size);
    const ViewTexels texels = timed(result.seconds_finding, [&] {
        return view_texels(context, drawn, camera, options.picture, colors, lookup);
    });
    timed(result.seconds_synthesis, [&] { pictures.make(texels, lookup.filter, result.work); });
    result.picture = timed(result.seconds_drawing, [&] {
        pictures.upload(drawn);
        const GlSurroundings around(context.gl(), scene, options.picture, options.light);
        return render_picture(context, drawn, around, camera, options.picture);
    });
    result.work.tiles = texels.count_tiles();
    result.work.texels_read = count_texels(source, view_part(source, texels, 1));
    result.work.texels_whole = texel_count(source.solid);
    return result;
}

}  // namespace burl
