#include "app/gl/draw/view_pictures.h"

#include <utility>

#include "app/gl/draw/view_scene.h"
#include "app/image/image_io.h"
#include "app/paint/texture.h"
#include "app/pipeline/material.h"
#include "app/surface/tangents.h"
#include "atlas/base/error.h"
#include "atlas/solid/level.h"
#include "atlas/solid/texel_set.h"
#include "procedural/fill/normals.h"
#include "procedural/fill/pictures.h"

namespace burl {

namespace {

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

/// A synthesised picture of so many components as a texture.
SceneTexture texture_of(Image<Rgba8> image, std::size_t components) {
    SceneTexture texture;
    auto [colors, alpha] = colors_and_alpha(std::move(image));
    texture.image = std::move(colors);
    if (components == 4) texture.alpha = std::move(alpha);
    return texture;
}

/// Hidden surfaces show where something before it lets light through, so that no texel can be left
/// out.
Skips skips_of(const LazyOptions& options, const SceneMaterial& material) {
    Skips skips = options.skips;
    if (material.alpha != SceneAlpha::opaque) skips.forbid(Skip::unseen_tiles);
    return skips;
}

}  // namespace

ViewPictures::ViewPictures(Pipeline& pipeline, const Scene& scene, const LazyOptions& options)
    : pipeline_(pipeline),
      scene_(scene),
      options_(options),
      material_(baked_material(scene)),
      varies_(has_pictures(pipeline.recipe(), Packing::gltf)),
      source_{pipeline.mesh_atlas(), pipeline.solid(), pipeline.recipe(),
              varies_ ? LevelRule{} : options.rule, pipeline.masks()} {
    if (is_transparent(pipeline.recipe()) && has_color_paint(pipeline.recipe().paint))
        throw Error(ExitCode::usage,
                    "the recipe paints over a transparent texture, which is not done yet; add "
                    "--set material.alpha=opaque, or take the paint out");
}

void ViewPictures::make(const ViewTexels& texels, TextureFilter filter, ViewWork& work) {
    const TexelSet finest = averaged_part(source_, texels, skips_of(options_, material_));
    if (varies_)
        make_material(finest, work);
    else
        make_colors(texels, filter, work);
    if (material_.normals >= 0) make_normals(finest);
}

void ViewPictures::upload(GlScene& drawn) {
    for (auto& [number, texture] : made_)
        drawn.set_texture(number, like(std::move(texture), scene_, number));
    made_.clear();
}

void ViewPictures::make_colors(const ViewTexels& texels, TextureFilter filter, ViewWork& work) {
    const std::vector<TexelSet> part = options_.skips.allows(Skip::unseen_tiles)
                                           ? view_part(source_, texels, options_.cell)
                                           : whole_part(source_);
    made_[material_.texture] = view_texture(source_, part, texels, filter, options_.way,
                                            {options_.skips, &work.synthesis});
    work.texels_made = count_texels(source_, part);
}

/// Synthesises all pictures but the normals in one pass, as a bake without levels does.
void ViewPictures::make_material(const TexelSet& texels, ViewWork& work) {
    const Recipe& recipe = source_.recipe;
    const SolidAtlas part = cut_to(source_.solid, texels);
    const std::vector<MaterialPicture> others = material_pictures(recipe, Packing::gltf);
    std::vector<PicturePlan> plans{base_color_plan(recipe)};
    for (const MaterialPicture& one : others) plans.push_back(one.plan);
    std::vector<Image<Rgba8>> images = synthesize_pictures<Rgba8>(
        part, recipe.texture, plans, texture_from_solid(recipe), recipe.filter,
        options_.way.threads, recipe.precision.kind.value_or(PrecisionKind::float32),
        {options_.skips, &work.synthesis},
        source_.masks(source_.solid, recipe.texture, GraphOutput::planes, {}));
    SceneTexture& color = made_[material_.texture];
    color = texture_of(std::move(images[0]), is_transparent(recipe) ? 4 : 3);
    paint_over(part, recipe.paint, options_.way.threads, color.image);
    for (std::size_t i = 0; i < others.size(); ++i)
        if (const int number = texture_number(material_, others[i]); number >= 0)
            made_[number] = texture_of(std::move(images[i + 1]), others[i].components);
    work.texels_made = texel_count(part);
}

/// Synthesises the normals of the recipe's bumps in tangent space.
void ViewPictures::make_normals(const TexelSet& texels) {
    const Recipe& recipe = source_.recipe;
    const Mesh& mesh = pipeline_.atlas_mesh();
    const NormalFrames frames = make_normal_frames(
        mesh, source_.layout, {recipe.solid.space, options_.crease_degrees, true});
    made_[material_.normals].image = synthesize_normals<Rgb8>(
        cut_to(source_.solid, texels),
        {mesh, source_.layout.atlas(), frames.positions, frames.normals, frames.tangents},
        recipe.bump, texture_from_solid(recipe), recipe.filter, options_.way.threads,
        graph_precision(recipe),
        source_.masks(source_.solid, recipe.bump.input, GraphOutput::color, {}));
}

}  // namespace burl
