// Pictures of baked normal maps against the bumps themselves.
#include <filesystem>

#include <gtest/gtest.h>

#include "app/bake/texture.h"
#include "app/direct/render.h"
#include "app/gl/draw/render.h"
#include "app/image/image_diff.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/scene/scene.h"
#include "tests/app/gl/device/fixture.h"
#include "tests/app/support/direct_picture.h"
#include "tests/app/support/export_scene.h"
#include "tests/app/support/sample_scene.h"
#include "tests/app/support/scratch_folder.h"

namespace burl {
namespace {

class GlNormalMap : public GlTest {
  protected:
    static constexpr View view{40, 25, 3.0};
    static PictureOptions picture() { return {{160, 120}, true, 2}; }

    /// White with waves that tilt normals by up to some 30 degrees.
    static Recipe waves(AtlasKind kind) {
        Recipe recipe = parse_recipe(R"({"texture": {"stops": [[0, "#ffffff"]]},
            "bump": {"height": 0.03, "input": {"node": "sin", "input":
                {"node": "coordinate", "direction": [16, 8, -12]}}}})",
                                     "r");
        recipe.atlas.kind = kind;
        recipe.atlas.size = 512;
        return recipe;
    }

    static Image<Rgb8> truth(const Mesh& mesh, const Recipe& recipe) {
        return render_direct(mesh, recipe, orbit_camera(view, bounding_sphere(mesh), {160, 120}),
                             picture());
    }

    Image<Rgb8> drawn(const Scene& scene) {
        return render_scene(*context, scene, orbit_camera(view, bounding_sphere(scene), {160, 120}),
                            picture());
    }

    /// The mesh baked to a file, drawn from there.
    Image<Rgb8> baked(const std::string& path, const Mesh& mesh, const Recipe& recipe) {
        Pipeline pipeline(mesh);
        pipeline.set_recipe(recipe);
        ExportOptions options;
        options.normals = bake_normals(pipeline, NormalSpace::tangent, 8, 40.0);
        export_scene(path, pipeline.atlas_mesh(), pipeline.atlas(), pipeline.synthesize<Rgb8>(),
                     options);
        return drawn(load_scene(path));
    }

    static double psnr(const Image<Rgb8>& a, const Image<Rgb8>& b) {
        return diff_images(a, b, {.ignore = background_srgb}).psnr_db;
    }

    ScratchFolder folder;
};

TEST_F(GlNormalMap, LooksLikeTheGroundTruthFromEveryAtlas) {
    const Mesh mesh = sphere_mesh(24, 48);
    for (const AtlasKind kind : {AtlasKind::patch, AtlasKind::quad, AtlasKind::area}) {
        const Recipe recipe = waves(kind);
        const Image<Rgb8> exact = truth(mesh, recipe);
        for (const char* name : {"a.glb", "b.obj"})
            EXPECT_GT(psnr(baked(folder / name, mesh, recipe), exact), 40.0)
                << to_string(kind) << " " << name;
        Recipe flat = recipe;
        flat.bump.height = 0.0;
        EXPECT_LT(psnr(truth(mesh, flat), exact), 25.0) << "the bumps are hardly to be seen";
        flat.bump.height = -recipe.bump.height;
        EXPECT_LT(psnr(truth(mesh, flat), exact), 25.0) << "dents would pass for bumps";
    }
}

TEST_F(GlNormalMap, PlacementsCarryIt) {
    // Turned, mirrored, and stretched unevenly: normals go by cofactors in both renderers.
    Mesh mesh = sphere_mesh(24, 48);
    mesh.parts[0].instances = {Mat4d(1.0), placement(70, {1, 1, 1}, {2.5, 0, 0}),
                               placement(20, {-1, 1, 1}, {0, 2.5, 0}),
                               placement(0, {1, 0.5, 1.5}, {2.5, 2.5, 0})};
    const Recipe recipe = waves(AtlasKind::patch);
    EXPECT_GT(psnr(baked(folder / "a.glb", mesh, recipe), truth(mesh, recipe)), 38.0);
}

TEST_F(GlNormalMap, ScaleAndMissingMapsAreFollowed) {
    const Mesh mesh = sphere_mesh(24, 48);
    const Recipe recipe = waves(AtlasKind::patch);
    baked(folder / "a.glb", mesh, recipe);
    Recipe flat = recipe;
    flat.bump = {};
    const Image<Rgb8> smooth = truth(mesh, flat);
    Scene scene = load_scene(folder / "a.glb");
    scene.surfaces[0].material.normal_scale = 0.0f;
    EXPECT_GT(psnr(drawn(scene), smooth), 45.0);
    scene.surfaces[0].material.normal_scale = 1.0f;
    scene.surfaces[0].material.normals = -1;
    EXPECT_GT(psnr(drawn(scene), smooth), 45.0);
}

}  // namespace
}  // namespace burl
