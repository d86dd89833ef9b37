// Pictures of a square whose charts, scales and levels are known.
#include "app/measure/metrics_pictures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <tuple>

#include "app/scene/shading.h"
#include "atlas/measure/uv_atlas.h"
#include "tests/atlas/support/made_meshes.h"

namespace burl {
namespace {

/// Two triangles of the unit square; the second has a quarter of the first one's area in the
/// texture of 64 x 64 texels.
struct Pictured {
    Mesh mesh = made::square();
    Atlas atlas;
    SolidAtlas solid;

    Pictured() {
        for (std::size_t t = 0; t < 2; ++t)
            for (const std::uint32_t p : mesh.triangles[t]) {
                const Vec2d at(mesh.positions[p].x, mesh.positions[p].y);
                mesh.corners.uvs.push_back(t == 0 ? at : 0.5 * at);
            }
        atlas = atlas_from_uvs(mesh, made::neighbours_by_brute_force(mesh), 64);
        solid = rasterize_uvs(mesh, atlas, mesh.positions);
    }
    PicturedAtlas what() const { return {mesh, atlas, solid, View{0.0, 0.0, 3.5}}; }
};

using Color = std::tuple<int, int, int>;

std::set<Color> colors(const Image<Rgb8>& picture, std::size_t x, std::size_t width) {
    std::set<Color> found;
    for (std::size_t y = 0; y < picture.height(); ++y)
        for (const Rgb8& p : picture.row(y).subspan(x, width)) found.insert({p.r, p.g, p.b});
    return found;
}

TEST(MetricsPictures, ScaleColoursAreSymmetricInTheLogarithm) {
    const Vec3d even = scale_color(1.0);
    EXPECT_EQ(even.x, even.y);
    EXPECT_EQ(even.y, even.z);
    EXPECT_LT(glm::length(scale_color(0.5) - scale_color(0.0)), 1e-12);
    EXPECT_LT(glm::length(scale_color(2.0) - scale_color(100.0)), 1e-12);
    EXPECT_GT(scale_color(2.0).x, 10.0 * scale_color(2.0).z);
    EXPECT_GT(scale_color(0.5).z, 10.0 * scale_color(0.5).x);
    EXPECT_LT(glm::length(0.5 * (even + scale_color(2.0)) - scale_color(std::sqrt(2.0))), 1e-12);
}

TEST(MetricsPictures, ChartsHaveColoursOfTheirOwnInAtlasAndOnModel) {
    const Pictured square;
    const std::vector<std::uint32_t> apart{0, 1}, together{3, 3};
    const Image<Rgb8> two = charts_picture(square.what(), apart);
    ASSERT_EQ(two.width(), 512u);
    ASSERT_EQ(two.height(), 256u);
    EXPECT_EQ(colors(two, 0, 256).size(), 3u);  // and the gaps
    EXPECT_EQ(colors(charts_picture(square.what(), together), 0, 256).size(), 2u);
    const std::set<Color> model = colors(two, 256, 256);
    EXPECT_TRUE(model.contains({background_srgb.r, background_srgb.g, background_srgb.b}));
    EXPECT_GT(model.size(), 2u);
}

TEST(MetricsPictures, ScaleIsThatOfEachTriangle) {
    const Pictured square;
    const Image<Rgb8> picture = scale_picture(square.what());
    // The first triangle has the scale 1, the second 1/2; (x, y) in texels of 64, pixels of 256.
    const Rgb8 first = picture(4 * 60, 4 * 50), second = picture(4 * 5, 4 * 25);
    EXPECT_EQ(first.r, first.b);
    EXPECT_GT(first.r, 200);
    EXPECT_GT(int(second.b), int(second.r) + 100);
}

TEST(MetricsPictures, LevelsStandSideBySide) {
    const Pictured square;
    const TextureValues texture = fill_texture(
        square.solid, [](const Vec3d&) { return Vec3d(1.0, 0.0, 0.0); }, GapFill::nearest);
    const Image<Rgb8> picture = levels_picture(square.what(), texture);
    ASSERT_EQ(picture.width(), 7u * 256u);
    ASSERT_EQ(picture.height(), 512u);
    for (std::size_t l = 0; l < 7; ++l) {
        EXPECT_EQ(picture(l * 256 + 100, 100), (Rgb8{255, 0, 0}));
        EXPECT_EQ(picture(l * 256 + 128, 256 + 128), (Rgb8{255, 0, 0}));  // the model, unlit
        EXPECT_EQ(picture(l * 256 + 1, 257), background_srgb);
    }
}

}  // namespace
}  // namespace burl
