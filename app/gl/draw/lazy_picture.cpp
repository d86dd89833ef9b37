#include "app/gl/draw/lazy_picture.h"

#include <utility>

#include "app/base/stopwatch.h"
#include "app/gl/draw/view_scene.h"
#include "atlas/solid/texel_set.h"

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

}  // namespace

LazyPicture render_lazily(GlContext& context, Pipeline& pipeline, const View& view,
                          const LazyOptions& options) {
    context.make_current();
    LazyPicture result;
    const ViewSource source{pipeline.mesh_atlas(), pipeline.solid(), pipeline.recipe(),
                            options.rule};
    const Scene scene = baked_scene(pipeline, options.crease_degrees, options.pose);
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
