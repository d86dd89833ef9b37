#include "app/gl/draw/render.h"
#include "app/recipe/edit/recipe_json.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>

#include "app/export/export.h"
#include "app/image/convert_image.h"
#include "app/image/image_diff.h"
#include "app/image/image_io.h"
#include "app/pipeline/pipeline.h"
#include "app/surface/normals.h"
#include "tests/app/gl/device/fixture.h"
#include "tests/app/programs/run_program.h"
#include "tests/app/support/direct_picture.h"
#include "tests/app/support/export_scene.h"
#include "tests/app/support/sample_scene.h"
#include "tests/app/support/scratch_folder.h"

namespace burl {
namespace {

using GlRenderTest = GlTest;

/// Square [-1,1]^2 in the plane z = 0 facing +z; u to the right, v downwards.
Scene square_scene(const Image<Rgb8>& image) {
    Scene scene;
    scene.textures.push_back(
        {image, TextureFilter::nearest, TextureWrap::clamp, TextureWrap::clamp});
    Surface square;
    square.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    square.normals.assign(4, Vec3f(0, 0, 1));
    square.uvs = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    square.triangles = {{0, 1, 2}, {0, 2, 3}};
    square.material.texture = 0;
    scene.surfaces.push_back(square);
    return scene;
}

/// Checks every pixel of the square, seen straight on, against `expected(u, v)`.
void expect_picture(const Image<Rgb8>& picture, double distance,
                    const std::function<Rgb8(double, double)>& expected, int tolerance) {
    const double width = double(picture.width()), height = double(picture.height());
    const double half_height =
        distance * std::sqrt(2.0) * std::tan(17.5 * std::numbers::pi / 180.0);
    int covered = 0, wrong = 0;
    for (std::size_t y = 0; y < picture.height(); ++y) {
        for (std::size_t x = 0; x < picture.width(); ++x) {
            const double px = (2 * (double(x) + 0.5) - width) / height * half_height;
            const double py = (height - 2 * (double(y) + 0.5)) / height * half_height;
            const bool inside = std::max(std::abs(px), std::abs(py)) < 1.0;
            const Rgb8 want = inside ? expected(0.5 + 0.5 * px, 0.5 - 0.5 * py) : background_srgb;
            const Rgb8 have = picture(x, y);
            covered += inside;
            wrong += std::abs(want.r - have.r) > tolerance ||
                     std::abs(want.g - have.g) > tolerance || std::abs(want.b - have.b) > tolerance;
        }
    }
    EXPECT_GT(covered, 1000);
    EXPECT_EQ(wrong, 0);
}

Image<Rgb8> two_by_two() {
    Image<Rgb8> image(2, 2);
    image(0, 0) = {255, 0, 0};
    image(1, 0) = {0, 200, 30};
    image(0, 1) = {20, 40, 250};
    image(1, 1) = {255, 255, 255};
    return image;
}

Image<Rgb8> draw_square(GlContext& context, const Image<Rgb8>& image, TextureFilter filter) {
    const Scene scene = square_scene(image);
    const PictureOptions options{{90, 70}, false, 1};
    const Camera camera = orbit_camera({0, 0, 2.5}, bounding_sphere(scene), options.size);
    return render_scene(context, scene, camera, options, filter);
}

TEST_F(GlRenderTest, NearestIsTheTexelItself) {
    const Image<Rgb8> image = two_by_two();
    expect_picture(
        draw_square(*context, image, TextureFilter::nearest), 2.5,
        [&](double u, double v) { return image(u >= 0.5, v >= 0.5); }, 0);
}

TEST_F(GlRenderTest, LinearInterpolatesLinearLight) {
    const Image<Rgb8> image = two_by_two();
    const SrgbEncoder<std::uint8_t> encode;
    const auto lookup = [&](double u, double v) {
        const double s = std::clamp(2 * u - 0.5, 0.0, 1.0), t = std::clamp(2 * v - 0.5, 0.0, 1.0);
        const auto channel = [&](std::uint8_t Rgb8::*c) {
            const auto light = [&](std::size_t x, std::size_t y) {
                return srgb_decode(image(x, y).*c / 255.0);
            };
            return encode((1 - t) * ((1 - s) * light(0, 0) + s * light(1, 0)) +
                          t * ((1 - s) * light(0, 1) + s * light(1, 1)));
        };
        return Rgb8{channel(&Rgb8::r), channel(&Rgb8::g), channel(&Rgb8::b)};
    };
    expect_picture(draw_square(*context, image, TextureFilter::linear), 2.5, lookup, 2);
}

TEST_F(GlRenderTest, EveryCodeComesThroughUnchanged) {
    Image<Rgb8> image(16, 16);
    for (std::size_t i = 0; i < 256; ++i) {
        const auto code = std::uint8_t(i);
        image(i % 16, i / 16) = {code, std::uint8_t(255 - code), std::uint8_t(code ^ 0x55)};
    }
    expect_picture(
        draw_square(*context, image, TextureFilter::nearest), 2.5,
        [&](double u, double v) { return image(std::size_t(16 * u), std::size_t(16 * v)); }, 0);
}

TEST_F(GlRenderTest, SmallestMipLevelIsTheMeanOfLinearLight) {
    // 512 texels over less than 2 pixels: the last level, one texel, mean of black and white.
    Image<Rgb8> image(512, 512);
    for (std::size_t y = 0; y < 512; ++y) {
        for (std::size_t x = 0; x < 512; ++x) {
            if ((x + y) % 2 == 0) image(x, y) = {255, 255, 255};
        }
    }
    const Scene scene = square_scene(image);
    const PictureOptions options{{9, 9}, false, 1};
    const Camera camera = orbit_camera({0, 0, 20.0}, bounding_sphere(scene), options.size);
    const Image<Rgb8> picture = render_scene(*context, scene, camera, options, TextureFilter::mip);
    EXPECT_NEAR(picture(4, 4).r, 188, 1);
}

TEST_F(GlRenderTest, FlatColorIsExact) {
    const Mesh mesh = sphere_mesh(16, 32);
    const Rgb8 color{200, 100, 7};
    const Scene scene = scene_from_mesh(
        mesh, {Vec4f(float(srgb_decode(200 / 255.0)), float(srgb_decode(100 / 255.0)),
                     float(srgb_decode(7 / 255.0)), 1.0f),
               -1});
    const PictureOptions options{{64, 64}, false, 1};
    const Camera camera = orbit_camera({}, bounding_sphere(scene), options.size);
    const Image<Rgb8> picture = render_scene(*context, scene, camera, options);
    int covered = 0;
    for (const Rgb8& pixel : picture.pixels()) {
        EXPECT_TRUE(pixel == color || pixel == background_srgb);
        covered += pixel == color;
    }
    // A sphere of angular radius asin(1/3.5) covers tan^2 / tan(17.5 degrees)^2 of the inscribed
    // disk.
    const double radius = 32.0 * std::tan(std::asin(1.0 / 3.5)) / std::tan(17.5 * M_PI / 180.0);
    EXPECT_NEAR(covered, M_PI * radius * radius, 0.03 * M_PI * radius * radius);
}

/// Both renderers over one mesh in one colour, never that of the background.
struct Pair {
    Image<Rgb8> gl, direct;
};
Pair draw_both(GlContext& context, const Mesh& mesh, const View& view,
               const PictureOptions& options) {
    const Scene scene = scene_from_mesh(mesh, {Vec4f(0.5f, 0.25f, 0.125f, 1.0f), -1});
    const Camera camera = orbit_camera(view, bounding_sphere(mesh), options.size);
    return {render_scene(context, scene, camera, options),
            render_points(
                mesh, corner_normals(mesh, 40.0),
                [](const SurfacePoint&) { return Vec3d(0.5, 0.25, 0.125); }, camera, options)};
}

int coverage_differences(const Pair& pair) {
    int count = 0;
    for (std::size_t y = 0; y < pair.gl.height(); ++y) {
        for (std::size_t x = 0; x < pair.gl.width(); ++x) {
            count += (pair.gl(x, y) == background_srgb) != (pair.direct(x, y) == background_srgb);
        }
    }
    return count;
}

TEST_F(GlRenderTest, CoversWhatTheDirectRendererCovers) {
    const Pair pair =
        draw_both(*context, sphere_mesh(24, 48), {30, 20, 3.5}, {{400, 300}, false, 1});
    // About 820 samples lie along the silhouette; OpenGL snaps corners to 1/256 of a sample.
    EXPECT_LE(coverage_differences(pair), 10);
    EXPECT_LE(diff_images(pair.gl, pair.direct, {.ignore = background_srgb}).maximum, 0.0);
}

TEST_F(GlRenderTest, ShadesAsTheDirectRendererDoes) {
    const Pair pair =
        draw_both(*context, sphere_mesh(24, 48), {30, 20, 3.5}, {{200, 150}, true, 1});
    const ImageDiff diff = diff_images(pair.gl, pair.direct, {.ignore = background_srgb});
    EXPECT_GT(diff.pixels, 5000u);
    EXPECT_LE(diff.maximum, 1.5 / 255.0);
}

TEST_F(GlRenderTest, NearPlaneCutsBothAlike) {
    // The eye is inside the sphere of the cube, some triangles reach behind it.
    const Pair pair = draw_both(*context, cube_mesh(), {35, 25, 0.7}, {{160, 120}, true, 1});
    EXPECT_LE(coverage_differences(pair), 10);
    EXPECT_LE(diff_images(pair.gl, pair.direct, {.ignore = background_srgb}).maximum, 1.5 / 255);
    int empty = 0;
    for (const Rgb8& pixel : pair.direct.pixels()) empty += pixel == background_srgb;
    EXPECT_EQ(empty, 0);
}

TEST_F(GlRenderTest, PlacementsAgreeWithTheDirectRenderer) {
    Mesh mesh = cube_mesh();
    Mat4d other(1.0);
    other[0] = {0.5, 0.3, 0, 0};  // sheared and mirrored
    other[1] = {0, 1.5, 0, 0};
    other[2] = {0, 0, -1, 0};
    other[3] = {3, 1, -1, 1};
    mesh.parts[0].instances.push_back(other);
    const Pair pair = draw_both(*context, mesh, {20, 30, 3}, {{160, 120}, true, 1});
    EXPECT_LE(coverage_differences(pair), 10);
    const ImageDiff diff =
        diff_images(pair.gl, pair.direct, {.tolerance = 1.5 / 255, .ignore = background_srgb});
    // Sharp edges may fall to the one or the other side.
    EXPECT_LE(diff.above_tolerance, 10u);
    EXPECT_GT(diff.pixels, 3000u);
}

/// The whole way: mesh, atlas, texture, file, picture, against the texture at each pixel's point.
TEST_F(GlRenderTest, BakedFileLooksLikeTheGroundTruth) {
    const ScratchFolder folder;
    Recipe recipe = load_recipe("marble");
    recipe.atlas.size = 512;
    Pipeline pipeline(sphere_mesh(12, 24));
    pipeline.set_recipe(recipe);
    export_scene(folder / "sphere.glb", pipeline.atlas_mesh(), pipeline.atlas(),
                 pipeline.synthesize<Rgb8>());
    const Scene scene = load_scene(folder / "sphere.glb");

    const PictureOptions options{{160, 120}, true, 2};
    const Camera camera = orbit_camera({}, bounding_sphere(scene), options.size);
    // Trilinear lookups, as the file asks for, blur more than the truth does.
    const Image<Rgb8> baked = render_scene(*context, scene, camera, options, TextureFilter::linear);
    const Image<Rgb8> truth =
        render_direct(pipeline.mesh(), recipe,
                      orbit_camera({}, bounding_sphere(pipeline.mesh()), options.size), options);
    const ImageDiff diff = diff_images(baked, truth, {.ignore = background_srgb});
    EXPECT_GT(diff.pixels, 4000u);
    EXPECT_GT(diff.psnr_db, 46.0);
    // With the texture turned by half a period it must not match.
    plain_texture(recipe.texture)->quadric.j += 0.5;
    EXPECT_LT(diff_images(baked, render_direct(pipeline.mesh(), recipe, camera, options),
                          {.ignore = background_srgb})
                  .psnr_db,
              30.0);
}

TEST_F(GlRenderTest, TilesLeaveNoTrace) {
    // Wider than one tile of samples: the picture must go on across the tiles' border.
    const Pair pair = draw_both(*context, sphere_mesh(12, 24), {5, 5, 3}, {{1200, 200}, true, 2});
    EXPECT_GT(diff_images(pair.gl, pair.direct).psnr_db, 50.0);
}

TEST_F(GlRenderTest, FarFromTheOriginAndTinyLookTheSame) {
    const PictureOptions options{{120, 90}, true, 1};
    const auto picture_of = [&](const Vec3d& centre, double scale) {
        Mesh mesh = cube_mesh();
        for (Vec3d& p : mesh.positions) p = centre + scale * p;
        const Scene scene = scene_from_mesh(mesh, {});
        return render_scene(*context, scene,
                            orbit_camera({25, 20, 3}, bounding_sphere(scene), options.size),
                            options);
    };
    const Image<Rgb8> plain = picture_of(Vec3d(0.0), 1.0);
    EXPECT_GT(diff_images(plain, picture_of(Vec3d(1e6, -1e6, 1e6), 1.0)).psnr_db, 45.0);
    EXPECT_GT(diff_images(plain, picture_of(Vec3d(0.0), 1e-30)).psnr_db, 45.0);
    EXPECT_GT(diff_images(plain, picture_of(Vec3d(0.0), 1e30)).psnr_db, 45.0);
}

/// Blocks in red where the middle of their first triangle lies at x > 0, else green.
Image<RgbF> halves(const Mesh& mesh, const Atlas& atlas) {
    Image<RgbF> image(atlas.options.size, atlas.options.size);
    for (const Block& block : atlas.blocks) {
        double x = 0.0;
        for (const std::uint32_t p : mesh.triangles[std::size_t(block.lower)])
            x += mesh.positions[p].x;
        const RgbF color = x > 0.0 ? RgbF{1, 0, 0} : RgbF{0, 1, 0};
        for (std::uint32_t y = block.y; y < block.y + block.height; ++y)
            std::ranges::fill(image.row(y).subspan(block.x, block.width), color);
    }
    return image;
}

/// Pixels that are neither red nor green nor background.
int mixed_pixels(const Image<Rgb8>& picture) {
    int mixed = 0;
    for (const Rgb8& p : picture.pixels())
        mixed += p != background_srgb && p != Rgb8{255, 0, 0} && p != Rgb8{0, 255, 0};
    return mixed;
}

/// A quad atlas scatters triangles; minified lookups that keep to their block show one triangle.
TEST_F(GlRenderTest, MinifiedLookupsKeepToTheirBlock) {
    const ScratchFolder folder;
    const Mesh mesh = sphere_mesh(12, 24);
    Recipe recipe = load_recipe("marble");
    recipe.atlas.kind = AtlasKind::quad;
    recipe.atlas.size = 1024;
    Pipeline pipeline(mesh);
    pipeline.set_recipe(recipe);
    const Image<RgbF> texture = halves(pipeline.atlas_mesh(), pipeline.atlas());
    export_scene(folder / "sphere.glb", pipeline.atlas_mesh(), pipeline.atlas(), to_rgb8(texture));
    const Scene scene = load_scene(folder / "sphere.glb");
    ASSERT_EQ(scene.surfaces[0].blocks.size(), scene.surfaces[0].positions.size());
    for (std::size_t i = 0; i < scene.surfaces[0].blocks.size(); ++i) {
        const Vec4f& block = scene.surfaces[0].blocks[i];
        const Vec2d& uv = scene.surfaces[0].uvs[i];
        EXPECT_TRUE(uv.x > block.x && uv.y > block.y && uv.x < block.z && uv.y < block.w);
    }
    // A texture of 1024 texels in about 60 pixels: levels 4 and up.
    const PictureOptions options{{80, 60}, false, 1};
    const Camera camera = orbit_camera({}, bounding_sphere(scene), options.size);
    const int kept = mixed_pixels(render_scene(*context, scene, camera, options));
    Scene plain = scene;
    plain.surfaces[0].blocks.clear();
    const int crossed =
        mixed_pixels(render_scene(*context, plain, camera, options, TextureFilter::mip));
    EXPECT_GT(crossed, 100);
    EXPECT_LT(kept, crossed / 5);  // blocks under one texel at the level looked up
}

/// Pixels whose levels differ are drawn together, how many depends on the processor.
TEST_F(GlRenderTest, PicturesInBlocksAreTheSameOnAnyProcessor) {
    const test::Scratch scratch;
    const std::string scene = scratch / "a.glb";
    ASSERT_EQ(test::run_burl(scratch, "bake sample:icosphere --quiet -s 128 -a quad -r noise -o '" +
                                          scene + "'")
                  .exit_code,
              0);
    const auto drawn = [&](int bits) {
        const std::string picture = scratch / fmt::format("{}.png", bits);
        const test::Outcome outcome = test::run_burl(
            scratch,
            fmt::format("render '{}' -o '{}' --size 120x90 --supersample 1", scene, picture),
            fmt::format("MESA_SHADER_CACHE_DISABLE=true LP_NATIVE_VECTOR_WIDTH={}", bits));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return read_png(picture);
    };
    EXPECT_EQ(differing(drawn(128), drawn(256)), 0u);
}

TEST_F(GlRenderTest, LevelsOfTheFileAreLookedUp) {
    const ScratchFolder folder;
    Recipe recipe = load_recipe("marble");
    recipe.atlas.size = 256;
    Pipeline pipeline(sphere_mesh(12, 24));
    pipeline.set_recipe(recipe);
    // Level 0 is black, the others white: what is minified must come out white.
    ExportOptions options;
    for (std::size_t side = 128; side > 0; side /= 2)
        options.levels.push_back(Image<Rgb8>(side, side, {255, 255, 255}));
    export_scene(folder / "a.glb", pipeline.atlas_mesh(), pipeline.atlas(),
                 Image<Rgb8>(256, 256, {0, 0, 0}), options);
    const Scene scene = load_scene(folder / "a.glb");
    ASSERT_EQ(scene.textures[0].levels.size(), 8u);
    const PictureOptions picture{{40, 30}, false, 1};
    const Camera camera = orbit_camera({}, bounding_sphere(scene), picture.size);
    int white = 0, other = 0;
    const Image<Rgb8> rendered = render_scene(*context, scene, camera, picture);
    for (const Rgb8& p : rendered.pixels()) {
        white += p == Rgb8{255, 255, 255};
        other += p != Rgb8{255, 255, 255} && p != background_srgb;
    }
    EXPECT_GT(white, 200);
    EXPECT_LT(other, white / 10);  // pixels on silhouettes
}

}  // namespace
}  // namespace burl
