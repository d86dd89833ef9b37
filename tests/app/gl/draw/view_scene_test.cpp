// The scene of a view against what the reader of glTF finds in the file that an export writes.
#include "app/gl/draw/view_scene.h"
#include "app/recipe/edit/recipe_json.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/export/export.h"
#include "tests/app/support/export_scene.h"
#include "tests/app/support/sample_scene.h"
#include "tests/app/support/scratch_folder.h"

namespace burl {
namespace {

/// The round way: by a file.
Scene exported_scene(Pipeline& pipeline, double crease_degrees) {
    const ScratchFolder folder;
    ExportOptions options;
    options.crease_degrees = crease_degrees;
    const Vec2d size = pipeline.atlas().extent();
    if (!pipeline.recipe().bump.empty())
        options.normals = NormalMap{Image<Rgb8>(std::size_t(size.x), std::size_t(size.y)), true};
    export_scene(folder / "a.glb", pipeline.atlas_mesh(), pipeline.atlas(),
                 Image<Rgb8>(std::size_t(size.x), std::size_t(size.y)), options);
    return load_scene(folder / "a.glb");
}

void expect_same(const Surface& got, const Surface& expected) {
    EXPECT_EQ(got.positions, expected.positions);
    EXPECT_EQ(got.normals, expected.normals);
    EXPECT_EQ(got.uvs, expected.uvs);
    EXPECT_EQ(got.tangents, expected.tangents);
    EXPECT_EQ(got.colors, expected.colors);
    EXPECT_EQ(got.blocks, expected.blocks);
    EXPECT_EQ(got.triangles, expected.triangles);
    EXPECT_EQ(got.placements, expected.placements);
    EXPECT_EQ(got.material.factor, expected.material.factor);
    EXPECT_EQ(got.material.texture, expected.material.texture);
    EXPECT_EQ(got.material.normals, expected.material.normals);
    EXPECT_EQ(got.material.normal_scale, expected.material.normal_scale);
}

void expect_same(const Scene& got, const Scene& expected) {
    ASSERT_EQ(got.surfaces.size(), expected.surfaces.size());
    for (std::size_t i = 0; i < got.surfaces.size(); ++i) {
        SCOPED_TRACE(i);
        expect_same(got.surfaces[i], expected.surfaces[i]);
    }
    ASSERT_EQ(got.textures.size(), expected.textures.size());
    for (std::size_t i = 0; i < got.textures.size(); ++i) {
        EXPECT_EQ(got.textures[i].filter, expected.textures[i].filter) << i;
        EXPECT_EQ(got.textures[i].wrap_u, expected.textures[i].wrap_u) << i;
        EXPECT_EQ(got.textures[i].wrap_v, expected.textures[i].wrap_v) << i;
        EXPECT_EQ(got.textures[i].is_color, expected.textures[i].is_color) << i;
        EXPECT_TRUE(got.textures[i].levels.empty()) << i;
    }
    EXPECT_TRUE(got.files.empty());
    EXPECT_TRUE(got.notes.empty());
}

Recipe recipe_of(AtlasKind kind, Overscan overscan = Overscan::bilinear) {
    Recipe recipe = load_recipe("marble");
    recipe.atlas.kind = kind;
    recipe.atlas.overscan = overscan;
    recipe.atlas.size = 256;
    return recipe;
}

/// Two parts in several placements: plain, turned, mirrored, sheared and sheared first.
Mesh placed_mesh() {
    Mesh mesh = cube_mesh({1e3, -2, 3});
    const Mat4d shear = placement(0, Vec3d(1, 3, 1), {}) * placement(30, Vec3d(1), {1, 2, 3});
    const Mat4d mirror =
        placement(50, Vec3d(1), {0.1, 1e4, 3}) * placement(0, Vec3d(-1, 2, 0.5), {});
    mesh.parts = {{"body", 0, 4, {Mat4d(1.0), placement(0, Vec3d(1), {4, 0, 0}), mirror}},
                  {"empty", 4, 0, {Mat4d(1.0)}},
                  {"leg", 4, 8, {shear, Mat4d(1.0), shear * mirror, mirror}}};
    return mesh;
}

TEST(ViewScene, IsWhatAnExportedFileHolds) {
    for (const AtlasKind kind : {AtlasKind::quad, AtlasKind::patch, AtlasKind::area})
        for (const Overscan overscan : {Overscan::bilinear, Overscan::nearest})
            for (const double crease : {40.0, 5.0}) {
                SCOPED_TRACE(fmt::format("{} {} {}", to_string(kind), to_string(overscan), crease));
                Pipeline pipeline(sphere_mesh(24, 48));
                pipeline.set_recipe(recipe_of(kind, overscan));
                expect_same(baked_scene(pipeline, crease), exported_scene(pipeline, crease));
            }
}

TEST(ViewScene, HasTangentsAndNormalMapsWhereThereAreBumps) {
    Pipeline pipeline(sphere_mesh(12, 24));
    Recipe recipe = load_recipe("carved-wood");
    recipe.atlas.size = 256;
    ASSERT_FALSE(recipe.bump.empty());
    pipeline.set_recipe(recipe);
    const Scene scene = baked_scene(pipeline);
    EXPECT_GE(baked_material(scene).normals, 0);
    EXPECT_EQ(scene.surfaces[0].tangents.size(), scene.surfaces[0].positions.size());
    expect_same(scene, exported_scene(pipeline, 40.0));
}

TEST(ViewScene, PlacesPartsAsNodesDo) {
    Pipeline pipeline(placed_mesh());
    pipeline.set_recipe(recipe_of(AtlasKind::quad));
    const Scene scene = baked_scene(pipeline);
    ASSERT_EQ(scene.surfaces.size(), 4u) << "two parts, one of them with two sheared copies";
    EXPECT_EQ(scene.surfaces[0].placements.size(), 3u);
    expect_same(scene, exported_scene(pipeline, 40.0));
}

}  // namespace
}  // namespace burl
