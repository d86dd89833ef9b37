// Pictures of textures that hold nothing but what the pictures look up, against pictures of baked
// files and of whole textures.
#include "app/gl/draw/lazy_picture.h"
#include "app/recipe/edit/recipe_json.h"

#include <gtest/gtest.h>

#include "app/bake/material.h"
#include "app/bake/texture.h"
#include "app/export/export.h"
#include "app/image/image_io.h"
#include "app/recipe/edit/images.h"
#include "tests/app/gl/device/fixture.h"
#include "tests/app/support/export_scene.h"
#include "tests/app/support/sample_scene.h"
#include "tests/app/support/scratch_folder.h"

namespace burl {
namespace {

using GlLazyPictureTest = GlTest;

/// A ball in front of another, seen from +z.
Mesh two_balls() {
    Mesh mesh = sphere_mesh(12, 24);
    const Mesh ball = mesh;
    const auto points = std::uint32_t(mesh.positions.size());
    for (const Vec3d& p : ball.positions) mesh.positions.push_back(0.8 * p - Vec3d(0.2, 0, 2.5));
    for (const Triangle& t : ball.triangles)
        mesh.triangles.push_back({t[0] + points, t[1] + points, t[2] + points});
    add_whole_part(mesh);
    return mesh;
}

Pipeline pipeline_of(AtlasKind kind, std::uint32_t size, const std::string& recipe_name = "marble",
                     Mesh mesh = two_balls()) {
    Recipe recipe = load_recipe(recipe_name);
    recipe.atlas.kind = kind;
    recipe.atlas.size = size;
    if (kind == AtlasKind::patch || kind == AtlasKind::quad)
        recipe.atlas.overscan = Overscan::bilinear;
    Pipeline pipeline(std::move(mesh));
    pipeline.set_recipe(recipe);
    return pipeline;
}

LazyOptions small_picture(std::optional<TextureFilter> filter = {}) {
    LazyOptions options;
    options.picture = {{80, 60}, true, 2};
    options.filter = filter;
    return options;
}

constexpr std::array views{View{0.0, 0.0, 2.0}, View{30.0, 20.0, 3.5}, View{110.0, -60.0, 9.0},
                           View{0.0, 10.0, 0.6}};

/// Equal to the picture of everything; the texels that were not made for it.
std::uint64_t expect_same_picture(GlContext& context, Pipeline& pipeline, const View& view,
                                  LazyOptions options,
                                  std::initializer_list<std::uint32_t> cells = {8}) {
    options.skips.forbid(Skip::unseen_tiles);
    const LazyPicture whole = render_lazily(context, pipeline, view, options);
    EXPECT_GE(whole.work.texels_made, whole.work.texels_whole);
    options.skips = {};
    std::uint64_t spared = 0;
    for (const std::uint32_t cell : cells) {
        options.cell = cell;
        const LazyPicture lazy = render_lazily(context, pipeline, view, options);
        EXPECT_EQ(differing(lazy.picture, whole.picture), 0u);
        spared += whole.work.texels_made - lazy.work.texels_made;
        EXPECT_GE(lazy.work.texels_made, lazy.work.texels_read);
        EXPECT_GT(lazy.work.texels_read, 0u);
        EXPECT_GT(lazy.work.tiles, 0u);
    }
    return spared;
}

TEST_F(GlLazyPictureTest, EqualsThePictureOfEverything) {
    for (const AtlasKind kind : {AtlasKind::uniform, AtlasKind::area, AtlasKind::length,
                                 AtlasKind::quad, AtlasKind::patch}) {
        Pipeline pipeline = pipeline_of(kind, 256);
        for (const View& view : {views[0], views[2]})
            expect_same_picture(*context, pipeline, view, small_picture());
        EXPECT_GT(expect_same_picture(*context, pipeline, views[3], small_picture(), {1, 32}), 0u);
    }
}

TEST_F(GlLazyPictureTest, UnderEveryLookupFilter) {
    for (const AtlasKind kind : {AtlasKind::area, AtlasKind::quad, AtlasKind::patch}) {
        // Where it can be, no power of two.
        Pipeline pipeline = pipeline_of(kind, kind == AtlasKind::quad ? 256 : 250);
        for (const TextureFilter filter :
             {TextureFilter::nearest, TextureFilter::linear, TextureFilter::mip})
            EXPECT_GT(expect_same_picture(*context, pipeline, views[3], small_picture(filter)), 0u);
        expect_same_picture(*context, pipeline, views[1], small_picture(TextureFilter::mip));
    }
}

TEST_F(GlLazyPictureTest, ReadsTheMasksOfABake) {
    for (const AtlasKind kind : {AtlasKind::quad, AtlasKind::patch}) {
        Pipeline pipeline = pipeline_of(kind, 128);
        Recipe recipe = parse_recipe(R"({"texture": {"node": "mix", "a": "#200000", "b": "#f0e0c0",
            "amount": {"node": "occlusion"}}, "bump": {"input": {"node": "multiply", "a": 0.1,
            "b": {"node": "multiply", "a": {"node": "height_in_box"}, "b": {"node": "fbm"}}}}})",
                                     "r");
        recipe.atlas = pipeline.recipe().atlas;
        pipeline.set_recipe(recipe);
        for (const TextureFilter filter : {TextureFilter::linear, TextureFilter::mip})
            EXPECT_GT(expect_same_picture(*context, pipeline, views[3], small_picture(filter)), 0u);
        const ViewSource source{
            pipeline.mesh_atlas(), pipeline.solid(), pipeline.recipe(), {}, pipeline.masks()};
        const ViewTexels all(source.solid.size);
        const SceneTexture made =
            view_texture(source, whole_part(source), all, TextureFilter::linear, {});
        EXPECT_EQ(made.image, pipeline.synthesize<Rgb8>());
    }
}

/// A lazy picture equals the one drawn from a baked file.
TEST_F(GlLazyPictureTest, EqualsThePictureOfABakedFile) {
    const ScratchFolder scratch;
    for (const auto& [recipe, direct] :
         {std::pair{"marble", true}, std::pair{"hammered", false}, std::pair{"hammered", true}})
        for (const AtlasKind kind : {AtlasKind::area, AtlasKind::quad, AtlasKind::patch}) {
            Pipeline pipeline = pipeline_of(kind, 128, recipe);
            const bool levels = kind != AtlasKind::area;
            ExportOptions options;
            options.normals = bake_normals(pipeline, normals_asked("", pipeline.recipe(), "a.glb"),
                                           8, options.crease_degrees);
            BakedImage image = pipeline.synthesize<Rgb8>();
            if (levels) {
                const Image<RgbF> linear = pipeline.synthesize<RgbF>();
                options.levels =
                    convert_to(pipeline.levels(linear, 7, {.direct = direct}), ImageKind::rgb8);
                image = convert_to(linear, ImageKind::rgb8);
            }
            const std::string path = scratch / "a.glb";
            export_scene(path, pipeline.atlas_mesh(), pipeline.atlas(), image, options);
            const Scene scene = load_scene(path);
            for (const View& view : {views[1], views[3]}) {
                LazyOptions lazy = small_picture();
                lazy.rule.direct = direct;
                const Camera camera = orbit_camera(view, bounding_sphere(scene), lazy.picture.size);
                EXPECT_EQ(differing(render_scene(*context, scene, camera, lazy.picture),
                                    colors_and_alpha(
                                        render_lazily(*context, pipeline, view, lazy).picture)
                                        .first),
                          0u)
                    << recipe << " " << to_string(kind);
            }
        }
}

/// The scene that a bake of the pipeline's recipe to a .glb writes, without levels.
Scene baked_material_scene(Pipeline& pipeline, const std::string& path) {
    const Recipe& recipe = pipeline.recipe();
    ExportOptions options;
    if (!recipe.bump.empty())
        options.normals = bake_normals(pipeline, NormalSpace::tangent, 8, options.crease_degrees);
    BakedMaterial material = bake_material(pipeline, {.normals = options.normals.has_value()});
    options.material = material_factors(recipe);
    options.pictures = std::move(material.pictures);
    export_scene(path, pipeline.atlas_mesh(), pipeline.atlas(), material.color, options);
    return load_scene(path);
}

/// A material of which every channel varies, one by the mesh's shape.
Recipe recipe_of_all_channels(const std::string& alpha) {
    const std::string opacity = alpha == "opaque" ? "" : R"("opacity": "grain",)";
    RecipeImages images;
    return parse_recipe(
        R"({"solid": {"scale": 3}, "define": {"grain": {"node": "smoothstep", "low": -1, "high": 1,
            "input": {"node": "fbm", "octaves": 2}}, "hue": {"node": "mix", "a": "#201000",
            "b": "#f0c0a0", "amount": "grain"}},
        "material": {"base_color": "hue", "metallic": "grain", "roughness": "grain",
            "occlusion": {"node": "occlusion"}, "emissive": "hue", "emissive_strength": 2,
            "specular": "grain", "clearcoat": "grain", "clearcoat_roughness": "grain",
            "sheen": "hue", "sheen_roughness": "grain", "transmission": "grain", "ior": 1.7,)" +
            opacity + R"("alpha": ")" + alpha + R"(", "height": "grain"},
        "bump": {"height": 0.02}})",
        "m.json", {}, images);
}

/// Under a light that shows every picture of the material.
TEST_F(GlLazyPictureTest, EqualsThePictureOfABakedMaterial) {
    const ScratchFolder scratch;
    context->make_current();
    LazyOptions lazy = small_picture();
    lazy.picture.light.light = "studio";
    lazy.light = std::make_shared<const GlLight>(context->gl(),
                                                 prefilter(make_environment("studio", 64), 32));
    std::vector<Recipe> recipes{load_recipe("gold"), recipe_of_all_channels("opaque"),
                                recipe_of_all_channels("blend"), recipe_of_all_channels("mask")};
    for (std::size_t i = 0; i < recipes.size(); ++i) {
        Pipeline pipeline = pipeline_of(i % 2 == 0 ? AtlasKind::patch : AtlasKind::quad, 128);
        recipes[i].atlas = pipeline.recipe().atlas;
        pipeline.set_recipe(recipes[i]);
        const Scene scene = baked_material_scene(pipeline, scratch / "a.glb");
        const View& view = views[i < 2 ? 3 : 1];
        const Camera camera = orbit_camera(view, bounding_sphere(scene), lazy.picture.size);
        const GlSurroundings around(context->gl(), scene, lazy.picture, lazy.light);
        const GlScene uploaded(context->gl(), scene);
        const LazyPicture drawn = render_lazily(*context, pipeline, view, lazy);
        EXPECT_EQ(differing(render_picture(*context, uploaded, around, camera, lazy.picture),
                            drawn.picture),
                  0u)
            << i;
        const bool is_opaque = i < 2;
        EXPECT_EQ(drawn.work.texels_made < drawn.work.texels_whole, is_opaque) << i;
    }
}

/// Two balls in a line show one of them, and one ball shows a half at most.
TEST_F(GlLazyPictureTest, LeavesOutWhatIsHidden) {
    const auto made = [&](const Mesh& mesh, const View& view) {
        Pipeline pipeline = pipeline_of(AtlasKind::patch, 512, "marble", mesh);
        LazyOptions options = small_picture();
        options.cell = 1;
        options.picture.size = {400, 300};
        const ViewWork work = render_lazily(*context, pipeline, view, options).work;
        return double(work.texels_made) / double(work.texels_whole);
    };
    EXPECT_LT(made(sphere_mesh(12, 24), {0, 0, 4.0}), 0.55);
    EXPECT_GT(made(sphere_mesh(12, 24), {0, 0, 4.0}), 0.3);
    const double in_line = made(two_balls(), {0, 0, 3.5}), beside = made(two_balls(), {90, 0, 3.5});
    EXPECT_LT(in_line, 0.75 * beside);
    EXPECT_LT(made(sphere_mesh(12, 24), {0, 0, 1.2}), 0.2) << "a close look shows a part";
}

}  // namespace
}  // namespace burl
