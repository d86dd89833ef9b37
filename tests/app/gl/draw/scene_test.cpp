// A scene that is uploaded piece by piece against one that was uploaded at once, whose pictures
// gl_render_test checks against pictures without OpenGL.
#include "app/gl/draw/scene.h"
#include "app/recipe/edit/recipe_json.h"

#include <gtest/gtest.h>

#include "app/gl/draw/render.h"
#include "app/gl/draw/view_scene.h"
#include "app/pipeline/pipeline.h"
#include "app/scene/scene.h"
#include "tests/app/gl/device/fixture.h"
#include "tests/app/support/sample_scene.h"

namespace burl {
namespace {

using GlSceneTest = GlTest;

/// Two surfaces far from the origin: one with texture, normals and blocks, one with colours alone.
Scene two_surfaces() {
    Pipeline pipeline(sphere_mesh(12, 24));
    Recipe recipe = load_recipe("marble");
    recipe.atlas.kind = AtlasKind::quad;
    recipe.atlas.size = 64;
    pipeline.set_recipe(recipe);
    Scene scene = baked_scene(pipeline);
    scene.textures[std::size_t(baked_material(scene).texture)].image = sample_image(64);
    Surface plain;
    const Mesh cube = cube_mesh({1.6, 0.4, 0.2});
    plain.positions = cube.positions;
    for (std::size_t i = 0; i < plain.positions.size(); ++i) {
        plain.normals.push_back(Vec3f(glm::normalize(cube.positions[i] - Vec3d(1.6, 0.4, 0.2))));
        plain.colors.emplace_back(0.1 * double(i), 0.9, 0.5, 1.0);
    }
    plain.triangles = cube.triangles;
    scene.surfaces.push_back(plain);
    return scene;
}

TEST_F(GlSceneTest, PiecesMakeTheWhole) {
    const Scene scene = two_surfaces();
    context->make_current();
    const PictureOptions options{{160, 120}, true, 2};
    const Camera camera = orbit_camera({}, bounding_sphere(scene), options.size);
    const GlScene at_once(context->gl(), scene);
    const GlSurroundings around(context->gl(), scene, options);
    const Image<Rgba8> expected = render_picture(*context, at_once, around, camera, options);
    const auto programs = std::make_shared<GlScenePrograms>(context->gl());
    const std::vector<Mat4d> frames = unit_frames(scene);
    for (const std::size_t bytes : {std::size_t(1), std::size_t(1000), std::size_t(1) << 30}) {
        GlScene pieces(context->gl(), scene, programs, frames);
        int calls = 1;
        while (!pieces.upload(scene, bytes)) ++calls;
        EXPECT_GT(calls, bytes == 1 ? 1000 : bytes == 1000 ? 20 : 1) << bytes;
        EXPECT_EQ(differing(render_picture(*context, pieces, around, camera, options), expected),
                  0u)
            << bytes;
    }
}

TEST_F(GlSceneTest, ANewSceneTakesOverThePrograms) {
    const Scene scene = two_surfaces();
    context->make_current();
    const auto programs = std::make_shared<GlScenePrograms>(context->gl());
    const GLuint program = programs->use({.lit = true, .in_blocks = true}).get();
    const std::vector<Mat4d> frames = unit_frames(scene);
    for (int round = 0; round < 2; ++round) {
        GlScene drawn(context->gl(), scene, programs, frames);
        while (!drawn.upload(scene, 4096)) {
        }
        EXPECT_EQ(programs->use({.lit = true, .in_blocks = true}).get(), program);
    }
    EXPECT_NE(programs->use({.encoded = true, .lit = true, .in_blocks = true}).get(), program);
}

}  // namespace
}  // namespace burl
