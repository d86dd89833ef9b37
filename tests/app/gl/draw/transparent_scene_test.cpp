// Scenes that blend: layers in any order of triangles against Porter and Duff's "over", masks, and
// baked files against the ground truth.
#include <algorithm>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/gl/draw/render.h"
#include "app/image/image_diff.h"
#include "app/image/image_io.h"
#include "tests/app/gl/device/fixture.h"
#include "tests/app/programs/run_program.h"

namespace burl {
namespace {

using GlTransparentSceneTest = GlTest;

/// A square of the plane z, 2 wide, and its straight linear colour with alpha.
struct GlassPane {
    double z = 0.0;
    Vec4f color{1.0f};
};

/// All panes as one surface, in their order.
Surface surface_of(const std::vector<GlassPane>& panes, SceneAlpha alpha) {
    Surface surface;
    for (const GlassPane& pane : panes) {
        const auto first = std::uint32_t(surface.positions.size());
        for (const auto& [x, y] : {std::pair(-1.0, -1.0), {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}) {
            surface.positions.emplace_back(x, y, pane.z);
            surface.colors.push_back(pane.color);
        }
        surface.triangles.push_back({first, first + 1, first + 2});
        surface.triangles.push_back({first, first + 2, first + 3});
    }
    surface.normals.assign(surface.positions.size(), Vec3f(0, 0, 1));
    surface.material.alpha = alpha;
    return surface;
}

Image<Rgb8> draw_scene(GlContext& context, const Scene& scene) {
    const PictureOptions options{{21, 21}, false, 1};
    const Camera camera = orbit_camera({0, 0, 3}, bounding_sphere(scene), options.size);
    return render_scene(context, scene, camera, options);
}

/// The colours that the middle shows, from the back to the front.
Vec3d blended(std::vector<GlassPane> panes) {
    std::ranges::sort(panes, {}, &GlassPane::z);
    Vec3d light = background_linear();
    for (const GlassPane& pane : panes) {
        const double a = double(pane.color.w);
        light = a * Vec3d(Vec3f(pane.color)) + (1.0 - a) * light;
    }
    return light;
}

void expect_light(const Rgb8& have, const Vec3d& light) {
    const SrgbEncoder<std::uint8_t> encode;
    EXPECT_NEAR(have.r, encode(light.x), 1);
    EXPECT_NEAR(have.g, encode(light.y), 1);
    EXPECT_NEAR(have.b, encode(light.z), 1);
}

TEST_F(GlTransparentSceneTest, LayersAreBlendedInAnyOrder) {
    std::vector<GlassPane> panes{{0.9, {1, 0, 0, 0.5}},
                                 {0.4, {0, 0.5, 0, 0.25}},
                                 {0.1, {1, 1, 1, 0}},
                                 {-0.2, {0, 0, 1, 0.75}},
                                 {-0.9, {0.3, 0.9, 0, 0.5}}};
    const Vec3d expected = blended(panes);
    std::mt19937 random(3);
    for (int i = 0; i < 4; ++i) {
        std::ranges::shuffle(panes, random);
        Scene scene;
        scene.surfaces = {surface_of(panes, SceneAlpha::blend)};
        const Image<Rgb8> picture = draw_scene(*context, scene);
        expect_light(picture(10, 10), expected);
        EXPECT_EQ(picture(0, 0), background_srgb);
    }
}

TEST_F(GlTransparentSceneTest, WhatIsOpaqueHidesAndIsSeenThroughLayers) {
    const std::vector<GlassPane> front{{0.8, {1, 0, 0, 0.5}}}, behind{{-0.8, {0, 1, 0, 0.5}}};
    const std::vector<GlassPane> wall{{0.0, {0, 0, 1, 0.25}}};  // its alpha is not looked at
    Scene scene;
    scene.surfaces = {surface_of(behind, SceneAlpha::blend), surface_of(wall, SceneAlpha::opaque),
                      surface_of(front, SceneAlpha::blend)};
    expect_light(draw_scene(*context, scene)(10, 10), Vec3d(0.5, 0, 0.5));
}

TEST_F(GlTransparentSceneTest, MasksAreThereOrNot) {
    Scene scene;
    scene.surfaces = {surface_of({{0.0, {0, 1, 0, 0.5}}}, SceneAlpha::mask)};
    scene.surfaces[0].material.alpha_cutoff = 0.5f;
    EXPECT_EQ(draw_scene(*context, scene)(10, 10), (Rgb8{0, 255, 0}));
    scene.surfaces[0].material.alpha_cutoff = 0.51f;
    EXPECT_EQ(draw_scene(*context, scene)(10, 10), background_srgb);
}

TEST_F(GlTransparentSceneTest, TexturesHaveAlpha) {
    Scene scene;
    scene.surfaces = {surface_of({{0.0, {1, 1, 1, 1}}}, SceneAlpha::blend)};
    scene.surfaces[0].uvs = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    scene.surfaces[0].material.texture = 0;
    SceneTexture& texture = scene.textures.emplace_back();
    texture.image = Image<Rgb8>(2, 1, {255, 0, 0});
    texture.alpha = Image<Grey8>(2, 1, 51);
    texture.alpha(1, 0) = 204;
    texture.filter = TextureFilter::nearest;
    const Image<Rgb8> picture = draw_scene(*context, scene);
    expect_light(picture(7, 10), blended({{0.0, {1, 0, 0, 0.2f}}}));
    expect_light(picture(13, 10), blended({{0.0, {1, 0, 0, 0.8f}}}));
}

/// Bakes the recipe on a mesh, and compares the file's picture with the ground truth.
void expect_file_like_truth(const test::Scratch& scratch, const std::string& extension,
                            const std::string& json, double least) {
    const std::string recipe = scratch.write("r.json", json), file = scratch / ("a" + extension);
    const auto run = [&](const std::string& arguments) {
        const test::Outcome outcome = test::run_burl(scratch, arguments);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    };
    const auto picture = [&](const std::string& what, const std::string& name) {
        run(fmt::format("render {} --light headlight --size 200x150 -o '{}'", what,
                        scratch / name));
        return read_png(scratch / name);
    };
    run(fmt::format("bake sample:teapot -o '{}' --recipe '{}' --size 512", file, recipe));
    const ImageDiff diff = diff_images(
        picture("'" + file + "'", "file.png"),
        picture(fmt::format("--direct sample:teapot --recipe '{}'", recipe), "truth.png"));
    EXPECT_GT(diff.psnr_db, least) << extension;
}

TEST_F(GlTransparentSceneTest, BakedFilesLookLikeTheTruth) {
    const test::Scratch scratch;
    const std::string fade = R"({"texture": {"wrap": "clamp",
        "stops": [[0, "#00ff0000"], [0.5, "#c0201080"], [1, "#ffffff"]],
        "input": {"node": "field", "quadric": {"G": 1, "J": 0.5}}}})";
    for (const char* extension : {".glb", ".obj"})
        expect_file_like_truth(scratch, extension, fade, 30.0);
    expect_file_like_truth(scratch, ".glb", R"({"material": {"alpha": "mask", "base_color": {
        "node": "color_map", "stops": [[0, "#20408000"], [1, "#ffc040"]],
        "input": {"node": "remap", "in_low": -0.4, "in_high": 0.4,
                  "input": {"node": "fbm", "octaves": 1}}}}})",
                           24.0);
}

}  // namespace
}  // namespace burl
