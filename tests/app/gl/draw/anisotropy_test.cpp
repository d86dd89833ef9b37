// Lookups along the longer side of a footprint, against the host's own (atlas/measure/lookup.h).
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "app/gl/draw/render.h"
#include "atlas/base/mip_chain.h"
#include "atlas/base/srgb.h"
#include "atlas/measure/lookup.h"
#include "tests/app/gl/device/fixture.h"

namespace burl {
namespace {

constexpr std::size_t width = 16, height = 256;

/// Grey texels that differ from their neighbours in all directions.
Image<Rgb8> patterned() {
    Image<Rgb8> image(width, height);
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x) {
            const double value = std::sin(0.9 * double(x) + 0.2 * double(y)) +
                                 std::cos(0.013 * double(y) * double(y) - double(x));
            const auto code = std::uint8_t(std::lround(128.0 + 60.0 * value));
            image(x, y) = {code, code, code};
        }
    return image;
}

/// The square [-1,1]^2 in the plane z = 0 with a texture 16 times as high as wide.
Scene striped_square() {
    Scene scene;
    scene.textures.push_back(
        {patterned(), TextureFilter::mip, TextureWrap::clamp, TextureWrap::clamp});
    Surface square;
    square.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    square.normals.assign(4, Vec3f(0, 0, 1));
    square.uvs = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    square.triangles = {{0, 1, 2}, {0, 2, 3}};
    square.material.texture = 0;
    scene.surfaces.push_back(square);
    return scene;
}

using GlAnisotropyTest = GlTest;

TEST_F(GlAnisotropyTest, LookupsLieAlongTheLongerSide) {
    const Scene scene = striped_square();
    const PictureOptions options{{41, 41}, false, 1};
    const double distance = 3.0;
    const Camera camera = orbit_camera({0, 0, distance}, bounding_sphere(scene), options.size);
    context->make_current();
    GlScene uploaded(context->gl(), scene);
    const GlSurroundings around(context->gl(), scene, options);
    Image<Vec3f> linear(width, height);
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x)
            linear(x, y) = Vec3f(float(srgb_decode(scene.textures[0].image(x, y).r / 255.0)));
    const MipChain<Vec3f> chain = build_mip_chain(std::move(linear));
    // The square's part that a pixel sees straight on.
    const double pixel =
        2.0 * distance * std::sqrt(2.0) * std::tan(17.5 * std::numbers::pi / 180.0) / 41.0;
    const TexelSteps steps{{0.5 * pixel * double(width), 0.0}, {0.0, 0.5 * pixel * double(height)}};
    Image<Rgba8> before;
    for (const int most : {1, 4, 16}) {
        uploaded.set_anisotropy(most);
        const Image<Rgba8> picture = render_picture(*context, uploaded, around, camera, options);
        EXPECT_NE(picture, before) << most;
        before = picture;
        for (const std::size_t y : {10u, 15u, 20u, 25u, 30u})
            for (const std::size_t x : {10u, 17u, 20u, 28u}) {
                const Vec2d at((0.5 + 0.5 * pixel * (double(x) - 20.0)) * double(width),
                               (0.5 + 0.5 * pixel * (double(y) - 20.0)) * double(height));
                const double expected = sampler_lookup(chain, at, steps, most).x;
                EXPECT_NEAR(srgb_decode(picture(x, y).r / 255.0), expected, 0.015)
                    << most << " at " << x << ", " << y;
            }
    }
}

TEST_F(GlAnisotropyTest, OneLookupIsThePictureWithout) {
    const Scene scene = striped_square();
    const PictureOptions options{{41, 41}, false, 1};
    const Camera camera = orbit_camera({20, 70, 2.5}, bounding_sphere(scene), options.size);
    context->make_current();
    GlScene uploaded(context->gl(), scene);
    const GlSurroundings around(context->gl(), scene, options);
    const Image<Rgba8> without = render_picture(*context, uploaded, around, camera, options);
    uploaded.set_anisotropy(16);
    EXPECT_NE(render_picture(*context, uploaded, around, camera, options), without);
    uploaded.set_anisotropy(1);
    EXPECT_EQ(render_picture(*context, uploaded, around, camera, options), without);
}

}  // namespace
}  // namespace burl
