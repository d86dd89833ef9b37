#include "app/gl_lazy_picture.h"

#include <utility>

#include "app/stopwatch.h"
#include "app/view_scene.h"

namespace burl {

namespace {

/// Colours as the scene looks its own up, and the normals, if any.
void set_textures(GlScene& drawn, const Scene& scene, Pipeline& pipeline, SceneTexture colors,
                  double crease_degrees) {
    const SceneMaterial& material = baked_material(scene);
    const SceneTexture& empty = scene.textures[std::size_t(material.texture)];
    colors.wrap_u = empty.wrap_u;
    colors.wrap_v = empty.wrap_v;
    drawn.set_texture(material.texture, colors);
    if (material.normals < 0) return;
    SceneTexture bumps = scene.textures[std::size_t(material.normals)];
    bumps.image = pipeline.normal_map<Rgb8>(crease_degrees, true);
    drawn.set_texture(material.normals, bumps);
}

}  // namespace

LazyPicture render_lazily(GlContext& context, Pipeline& pipeline, const View& view,
                          const LazyOptions& options) {
    context.make_current();
    LazyPicture result;
    const SolidAtlas& solid = pipeline.solid();
    const Scene scene = baked_scene(pipeline, options.crease_degrees);
    const Camera camera = orbit_camera(view, bounding_sphere(scene), options.picture.size);
    GlScene drawn(context.gl(), scene, options.filter);
    const int colors_number = baked_material(scene).texture;
    const TextureLookup lookup = lookup_of(scene, colors_number, options.filter, solid.size);
    const ViewTexels texels = timed(result.seconds_finding, [&] {
        return view_texels(context, drawn, camera, options.picture, colors_number, lookup,
                           most_slack(lookup));
    });
    const SolidAtlas part = timed(result.seconds_finding, [&] {
        return options.everything ? solid : view_atlas(solid, texels, options.cell);
    });
    SceneTexture colors = timed(result.seconds_synthesis, [&] {
        return view_texture(pipeline, part, texels, lookup.filter, options.way);
    });
    result.picture = timed(result.seconds_drawing, [&] {
        set_textures(drawn, scene, pipeline, std::move(colors), options.crease_degrees);
        return render_scene(context, drawn, camera, options.picture);
    });
    result.work = view_work(solid, part, texels);
    return result;
}

}  // namespace burl
