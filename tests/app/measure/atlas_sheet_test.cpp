// Pictures of an atlas against what single texels show, found triangle by triangle, and the way
// from a texel to the object and back.
#include "app/measure/atlas_sheet.h"
#include "app/recipe/edit/recipe_json.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

#include "app/gl/draw/view_scene.h"
#include "app/measure/metrics_pictures.h"
#include "app/scene/sheet_frame.h"
#include "app/scene/surface_pick.h"
#include "procedural/color/srgb.h"
#include "tests/atlas/support/made_meshes.h"

namespace burl {
namespace {

struct Place {
    std::size_t triangle = 0;
    Vec3d point{0.0};  ///< of the mesh
};

/// The triangle that a texel's centre lies well inside of, by solving for its corners' weights.
std::optional<Place> search_all(const Mesh& mesh, const Atlas& atlas, const Vec2d& texel) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = atlas.corners[t];
        const Mat3d corners(Vec3d(a, 1), Vec3d(b, 1), Vec3d(c, 1));
        const Vec3d weights = glm::inverse(corners) * Vec3d(texel, 1);
        if (!glm::all(glm::greaterThan(weights, Vec3d(1e-3)))) continue;
        Vec3d point(0.0);
        for (int k = 0; k < 3; ++k)
            point += weights[k] * mesh.positions[mesh.triangles[t][std::size_t(k)]];
        return Place{t, point};
    }
    return {};
}

class AtlasSheetTest : public testing::TestWithParam<const char*> {
  protected:
    AtlasSheetTest() : pipeline_(made::ball(3)) {
        pipeline_.set_recipe(
            load_recipe("marble", {"atlas.size=128", std::string("atlas.kind=") + GetParam()}));
    }
    /// visit(x, y, place) for texels all over the atlas.
    template <class Visit>
    void for_some(const Visit& visit) {
        int found = 0;
        for (std::size_t y = 3; y < 128; y += 9)
            for (std::size_t x = 2; x < 128; x += 7)
                if (const auto place = search_all(pipeline_.atlas_mesh(), pipeline_.atlas(),
                                                  {double(x) + 0.5, double(y) + 0.5})) {
                    visit(x, y, *place);
                    ++found;
                }
        EXPECT_GT(found, 100);
    }

    Pipeline pipeline_;
};

TEST_P(AtlasSheetTest, CoordinatesAreThoseOfTheMesh) {
    const AtlasSheet sheet = atlas_sheet(pipeline_);
    const Image<Rgb8> picture = sheet_levels(sheet, SheetMode::solid).front();
    const Box3 box = bounding_box(pipeline_.mesh());
    for_some([&](std::size_t x, std::size_t y, const Place& place) {
        const Vec3d codes = 255.0 * (place.point - box.low) / box.longest_side();
        EXPECT_NEAR(picture(x, y).r, codes.x, 0.501);
        EXPECT_NEAR(picture(x, y).g, codes.y, 0.501);
        EXPECT_NEAR(picture(x, y).b, codes.z, 0.501);
        const auto facts = texel_facts(sheet, std::int64_t(x), std::int64_t(y));
        ASSERT_TRUE(facts);
        EXPECT_EQ(facts->triangle, place.triangle);
        const Affine3 map = solid_from_mesh(pipeline_.mesh(), SolidSpace::unit);
        EXPECT_LT(glm::distance(facts->point, map(place.point)), 1e-9);
    });
}

TEST_P(AtlasSheetTest, ChartsHaveOneColourEach) {
    const AtlasSheet sheet = atlas_sheet(pipeline_);
    const Image<Rgb8> picture = sheet_levels(sheet, SheetMode::charts).front();
    std::map<std::uint32_t, Rgb8> colors;
    for_some([&](std::size_t x, std::size_t y, const Place& place) {
        const std::uint32_t chart = pipeline_.atlas().charts[place.triangle];
        const auto [color, first] = colors.emplace(chart, picture(x, y));
        EXPECT_EQ(color->second, picture(x, y));
        const auto other = colors.find(chart + 1);
        if (other != colors.end()) {
            EXPECT_NE(other->second, picture(x, y));
        }
    });
    EXPECT_GT(colors.size(), 1u);
}

TEST_P(AtlasSheetTest, ScalesAreRatiosOfAreas) {
    const AtlasSheet sheet = atlas_sheet(pipeline_);
    const Image<Rgb8> picture = sheet_levels(sheet, SheetMode::scale).front();
    const Mesh& mesh = pipeline_.atlas_mesh();
    double total = 0.0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) total += triangle_area(mesh, t);
    for_some([&](std::size_t x, std::size_t y, const Place& place) {
        const auto& [a, b, c] = pipeline_.atlas().corners[place.triangle];
        const Vec2d u = b - a, v = c - a;
        const double share = 0.5 * std::abs(u.x * v.y - u.y * v.x) / (128.0 * 128.0);
        const double scale = std::sqrt(share / triangle_area(mesh, place.triangle) * total);
        EXPECT_NEAR(texel_facts(sheet, std::int64_t(x), std::int64_t(y))->scale, scale, 1e-9);
        EXPECT_NEAR(picture(x, y).g, 255.0 * srgb_encode(scale_color(scale).y), 0.501);
        EXPECT_NEAR(picture(x, y).r, 255.0 * srgb_encode(scale_color(scale).x), 0.501);
    });
}

TEST_P(AtlasSheetTest, CoarserLevelsShowWhatLiesAtTheirTexelsCentres) {
    const AtlasSheet sheet = atlas_sheet(pipeline_);
    const std::vector<Image<Rgb8>> levels = sheet_levels(sheet, SheetMode::solid);
    ASSERT_EQ(levels.size(), 8u);
    const Box3 box = bounding_box(pipeline_.mesh());
    for (std::size_t y = 0; y < 32; ++y)
        for (std::size_t x = 0; x < 32; ++x) {
            const Vec2d centre(4.0 * double(x) + 2.0, 4.0 * double(y) + 2.0);
            const auto place = search_all(pipeline_.atlas_mesh(), pipeline_.atlas(), centre);
            // The texel of level 0 that decides lies at the centre's right.
            const auto owner =
                search_all(pipeline_.atlas_mesh(), pipeline_.atlas(), centre + Vec2d(0.5));
            if (!place || !owner || place->triangle != owner->triangle) continue;
            const Vec3d codes = 255.0 * (place->point - box.low) / box.longest_side();
            EXPECT_NEAR(levels[2](x, y).r, codes.x, 0.51);
            EXPECT_NEAR(levels[2](x, y).b, codes.z, 0.51);
        }
}

TEST_P(AtlasSheetTest, FromATexelToTheObjectAndBack) {
    const auto scene = std::make_shared<const Scene>(baked_scene(pipeline_));
    const SurfacePick pick(scene);
    for_some([&](std::size_t x, std::size_t y, const Place& place) {
        const Vec2d uv = (Vec2d(double(x), double(y)) + 0.5) / 128.0;
        const auto there = pick.at(uv);
        ASSERT_TRUE(there);
        EXPECT_LT(glm::distance(there->mesh_point, place.point), 1e-5);
        // A ball about the origin: nothing lies between its surface and whoever looks from afar.
        const Vec3d eye = 3.0 * there->point;
        const auto back = pick.meet({eye, there->point - eye});
        ASSERT_TRUE(back);
        EXPECT_LT(glm::distance(128.0 * back->uv, 128.0 * uv), 0.02);
    });
}

INSTANTIATE_TEST_SUITE_P(Kinds, AtlasSheetTest, testing::Values("patch", "quad"));

TEST(TexelFacts, ThereAreNoneBesideTheTexture) {
    Pipeline pipeline(made::ball(2));
    pipeline.set_recipe(load_recipe("marble", {"atlas.size=64"}));
    const AtlasSheet sheet = atlas_sheet(pipeline);
    EXPECT_TRUE(texel_facts(sheet, 20, 20));
    for (const auto& [x, y] : {std::pair(-1, 3), std::pair(3, -1), std::pair(64, 3)})
        EXPECT_FALSE(texel_facts(sheet, x, y));
}

TEST(SheetFrame, WhatIsUnderThePointerStaysThere) {
    const Vec2d size(420, 600), pointer(100, 410);
    const SheetFrame frame = panned({}, size, {31, -17});
    const Vec2d uv = uv_at(frame, size, pointer);
    EXPECT_LT(glm::distance(uv_at(zoomed(frame, size, pointer, 5), size, pointer), uv), 1e-12);
    EXPECT_LT(glm::distance(uv_at(panned(frame, size, {8, 9}), size, pointer + Vec2d(8, 9)), uv),
              1e-12);
    EXPECT_LT(glm::distance(pixel_at(frame, size, uv), pointer), 1e-9);
    EXPECT_EQ(zoomed(frame, size, pointer, 1000).zoom, 256.0);
}

TEST(SheetFrame, TheWholeTextureFitsAtFirstAndSomeStaysInSight) {
    for (const Vec2d& size : {Vec2d(300, 800), Vec2d(800, 300)}) {
        EXPECT_TRUE(glm::all(glm::greaterThanEqual(pixel_at({}, size, Vec2d(0.0)), Vec2d(0.0))));
        EXPECT_TRUE(glm::all(glm::lessThanEqual(pixel_at({}, size, Vec2d(1.0)), size)));
        const Vec2d middle = uv_at(panned({}, size, {1e5, -1e5}), size, 0.5 * size);
        EXPECT_EQ(middle, Vec2d(0.0, 1.0));
    }
}

}  // namespace
}  // namespace burl
