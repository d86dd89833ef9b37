#include "app/gl/draw/lazy_picture.h"

#include <algorithm>
#include <utility>

#include "app/base/stopwatch.h"
#include "app/gl/draw/view_scene.h"
#include "app/pipeline/material.h"
#include "app/scene/up_axis.h"
#include "app/surface/tangents.h"
#include "atlas/base/error.h"
#include "atlas/build/block_levels.h"
#include "atlas/solid/level.h"
#include "atlas/solid/texel_set.h"
#include "procedural/batch/row_tasks.h"
#include "procedural/color/srgb.h"
#include "procedural/fill/normals.h"

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

/// The texture with the wrap modes and content of the scene's texture `number`.
SceneTexture like(SceneTexture texture, const Scene& scene, int number) {
    const SceneTexture& own = scene.textures[std::size_t(number)];
    texture.wrap_u = own.wrap_u, texture.wrap_v = own.wrap_v;
    texture.is_color = own.is_color;
    return texture;
}

/// The texels of level 0 of a texture whose levels OpenGL averages: the normals.
TexelSet averaged_part(ViewSource source, const ViewTexels& view, const Skips& skips) {
    source.rule = {};
    return skips.allows(Skip::unseen_tiles) ? view_part(source, view, 1)[0] : whole_part(source)[0];
}

/// The normals of the recipe's bumps in tangent space at `texels`. `mesh` is the one that the atlas
/// was built from.
Image<Rgb8> view_normals(const ViewSource& source, const Mesh& mesh, const TexelSet& texels,
                         double crease_degrees, int threads) {
    const Recipe& recipe = source.recipe;
    const NormalFrames frames =
        make_normal_frames(mesh, source.layout, {recipe.solid.space, crease_degrees, true});
    return synthesize_normals<Rgb8>(
        cut_to(source.solid, texels),
        {mesh, source.layout.atlas(), frames.positions, frames.normals, frames.tangents},
        recipe.bump, texture_from_solid(recipe), recipe.filter, threads, graph_precision(recipe),
        source.masks ? source.masks(source.solid, recipe.bump.input, GraphOutput::color)
                     : MaskImages());
}

}  // namespace

std::uint32_t ViewSource::source(std::uint32_t level) const {
    if (!rule.direct || level > last_level(layout)) return 0;
    return source_level(layout, rule, level);
}

MaskImages ViewSource::color_masks(const SolidAtlas& level) const {
    return masks ? masks(level, recipe.texture, GraphOutput::color) : MaskImages();
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
    if (is_transparent(pipeline.recipe()))
        throw Error(
            ExitCode::unsupported,
            "--lazy does not draw what is transparent; use --direct, or bake the recipe and "
            "draw the file, or add --set material.alpha=opaque");
    context.make_current();
    LazyPicture result;
    const ViewSource source{pipeline.mesh_atlas(), pipeline.solid(), pipeline.recipe(),
                            options.rule, pipeline.masks()};
    Scene scene = baked_scene(pipeline, options.crease_degrees, options.pose);
    turn(scene, options.upright);
    const SceneMaterial& material = baked_material(scene);
    const Camera camera = orbit_camera(view, bounding_sphere(scene), options.picture.size);
    GlScene drawn(context.gl(), scene, options.filter);
    const TextureLookup lookup =
        lookup_of(scene, material.texture, options.filter, source.solid.size);
    const ViewTexels texels = timed(result.seconds_finding, [&] {
        return view_texels(context, drawn, camera, options.picture, material.texture, lookup);
    });
    SceneTexture colors, normals;
    timed(result.seconds_synthesis, [&] {
        const std::vector<TexelSet> part = options.skips.allows(Skip::unseen_tiles)
                                               ? view_part(source, texels, options.cell)
                                               : whole_part(source);
        colors = view_texture(source, part, texels, lookup.filter, options.way,
                              {options.skips, &result.work.synthesis});
        result.work.texels_made = count_texels(source, part);
        if (material.normals >= 0)
            normals.image = view_normals(source, pipeline.atlas_mesh(),
                                         averaged_part(source, texels, options.skips),
                                         options.crease_degrees, options.way.threads);
    });
    result.picture = timed(result.seconds_drawing, [&] {
        drawn.set_texture(material.texture, like(std::move(colors), scene, material.texture));
        if (material.normals >= 0)
            drawn.set_texture(material.normals, like(std::move(normals), scene, material.normals));
        return render_scene(context, drawn, camera, options.picture);
    });
    result.work.tiles = texels.count_tiles();
    result.work.texels_read = count_texels(source, view_part(source, texels, 1));
    result.work.texels_whole = texel_count(source.solid);
    return result;
}

}  // namespace burl
