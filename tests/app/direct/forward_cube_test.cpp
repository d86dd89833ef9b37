// The cubes of "Bresenham Noise".
#include "app/direct/forward_cube.h"
#include "app/recipe/edit/recipe_json.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "app/recipe/recipe.h"
#include "app/scene/shading.h"

namespace burl {
namespace {

/// f = s, t or r in shades of grey over [0,1].
Texture ramp(int axis) {
    Texture texture;
    (axis == 0 ? texture.quadric.d : axis == 1 ? texture.quadric.g : texture.quadric.i) = 0.5;
    texture.colors = {Wrap::clamp, {{0.0, {0, 0, 0}}, {1.0, {255, 255, 255}}}};
    return texture;
}

/// Linear light as a share of the brightest of its face, from a code.
double light(const Image<Rgb8>& image, std::size_t x, std::size_t y) {
    return linear_light(image(x, y)).g;
}

TEST(ForwardCube, OriginIsLowestAndTheFarCornerHighest) {
    constexpr std::size_t side = 200, middle = side / 2;
    // Of the hexagon's height of 180: the vertex (0,0,1), where the faces meet, is the middle.
    for (int axis = 0; axis < 3; ++axis) {
        const Image<Rgb8> picture = draw_cube(ramp(axis), 1.0, side, CubeMethod::pixelwise);
        EXPECT_EQ(picture(middle, 5), background_srgb);
        EXPECT_EQ(picture(middle, 195), background_srgb);
        EXPECT_GT(light(picture, middle, 14), 0.9);        // near (1,1,1), on the face r = 1
        EXPECT_LT(light(picture, middle - 3, 187), 0.05);  // near (0,0,0)
        EXPECT_LT(light(picture, middle + 3, 187), 0.05);
        EXPECT_NEAR(light(picture, middle, middle - 5), axis == 2 ? 1.0 : 0.05, 0.06);
        // Halfway up the upper face's diagonal s and t are both a half.
        EXPECT_NEAR(light(picture, middle, 55), axis == 2 ? 1.0 : 0.5, 0.02);
    }
}

TEST(ForwardCube, CoversTheHexagonOnce) {
    constexpr std::size_t side = 160;
    const Image<Rgb8> picture = draw_cube(ramp(2), 1.0, side, CubeMethod::pixelwise);
    std::size_t covered = 0;
    for (const Rgb8& pixel : picture.pixels()) covered += pixel != background_srgb;
    // Area sqrt(3) for a cube of 1, whose height sqrt(8/3) is 144 pixels.
    EXPECT_NEAR(double(covered), std::sqrt(3.0) * 144.0 * 144.0 * 3.0 / 8.0, 200.0);
}

TEST(ForwardCube, ForwardDifferencesDrawNearlyTheSamePicture) {
    std::size_t all = 0;
    for (const auto& [name, size] : {std::pair{"bresenham-wood", 1.0}, {"bresenham-marble", 2.0}}) {
        const Texture texture = *plain_texture(load_recipe(name).texture);
        const Image<Rgb8> each = draw_cube(texture, size, 160, CubeMethod::pixelwise);
        const Image<Rgb8> forward = draw_cube(texture, size, 160, CubeMethod::forward);
        const Image<Rgb8> different = disagreement(each, forward);
        std::size_t black = 0;
        int most = 0;
        for (std::size_t i = 0; i < each.pixels().size(); ++i) {
            const Rgb8 &a = each.pixels()[i], &b = forward.pixels()[i];
            const Rgb8 agree = a == background_srgb ? background_srgb : Rgb8{255, 255, 255};
            EXPECT_EQ(different.pixels()[i], (a == b ? agree : Rgb8{0, 0, 0}));
            black += a != b;
            most = std::max({most, std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
        }
        EXPECT_LE(most, 1) << name;  // as the paper found
        all += black;
    }
    EXPECT_GT(all, 0u);  // it is another arithmetic
    EXPECT_LT(all, 20u);
}

}  // namespace
}  // namespace burl
