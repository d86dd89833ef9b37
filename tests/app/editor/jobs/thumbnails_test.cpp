// The gallery's balls: round, lit, of the recipe's colours, and made once beside the program.
#include "app/editor/jobs/thumbnails.h"
#include "app/recipe/edit/recipe_json.h"

#include <gtest/gtest.h>

#include <atomic>

#include "app/scene/shading.h"
#include "procedural/color/srgb.h"

namespace burl {
namespace {

constexpr const char* plain = R"({"burl": 1, "texture": {"node": "constant", "value": "#804020"}})";

TEST(BallPicture, FillsTheCircleWithLitColours) {
    const int side = 48;
    const Image<Rgb8> ball = ball_picture(parse_recipe(plain, "test"), side);
    ASSERT_EQ(ball.width(), std::size_t(side));
    ASSERT_EQ(ball.height(), std::size_t(side));
    const auto at = [&](double x, double y) {
        return ball(std::size_t((0.5 + 0.5 * x) * side), std::size_t((0.5 + 0.5 * y) * side));
    };
    // Towards the eye the light is full, at the rim what is left is the ambient.
    EXPECT_EQ(at(0.0, 0.0), (Rgb8{0x80, 0x40, 0x20}));
    const double lit = srgb_decode(at(0.93, 0.0).r / 255.0) / srgb_decode(0x80 / 255.0);
    EXPECT_GT(lit, ambient);
    EXPECT_LT(lit, 0.65);
    for (const auto& [x, y] : {std::pair{0.0, -0.97}, {0.0, 0.97}, {-0.97, 0.0}, {0.97, 0.0}})
        EXPECT_NE(at(x, y), background_srgb) << x << " " << y;
    for (const auto& [x, y] : {std::pair{-0.97, -0.97}, {0.97, 0.97}, {-0.97, 0.97}})
        EXPECT_EQ(at(x, y), background_srgb) << x << " " << y;
}

TEST(BallPicture, HasLevelsOfMeansDownToOnePixel) {
    Image<Rgb8> picture(12, 12);
    for (std::size_t y = 0; y < 12; ++y)
        for (std::size_t x = 0; x < 12; ++x)
            picture(x, y) = {std::uint8_t(20 * x), std::uint8_t(20 * y), std::uint8_t(x + y)};
    const auto levels = picture_levels(picture);
    ASSERT_EQ(levels.size(), 4u);
    EXPECT_EQ(levels[0], picture);
    EXPECT_EQ(levels[1].width(), 6u);
    EXPECT_EQ(levels[2].height(), 3u);
    EXPECT_EQ(levels[3].width(), 1u);
    EXPECT_EQ(levels[1](2, 5), (Rgb8{90, 210, 15}));
    EXPECT_EQ(levels[2](1, 0), (Rgb8{110, 30, 7}));
}

TEST(EditThumbnails, MakeAPictureOnceWhenItIsAskedFor) {
    std::atomic<int> woken = 0;
    EditThumbnails thumbnails([&] { ++woken; });
    EXPECT_TRUE(thumbnails.idle());
    EXPECT_EQ(thumbnails.picture("wood", 16), nullptr);
    EXPECT_EQ(thumbnails.picture("wood", 16), nullptr);
    EXPECT_EQ(thumbnails.picture("marble", 16), nullptr);
    thumbnails.wait();
    EXPECT_TRUE(thumbnails.idle());
    const auto wood = thumbnails.picture("wood", 16);
    ASSERT_NE(wood, nullptr);
    EXPECT_EQ(*wood, ball_picture(load_recipe("wood"), 16));
    EXPECT_EQ(thumbnails.picture("wood", 16), wood);
    ASSERT_NE(thumbnails.picture("marble", 16), nullptr);
    EXPECT_NE(*thumbnails.picture("marble", 16), *wood);
    EXPECT_LE(woken, 2);
}

TEST(EditThumbnails, ARecipeThatCannotBeReadHasNone) {
    EditThumbnails thumbnails([] {});
    EXPECT_EQ(thumbnails.picture("no such preset", 16), nullptr);
    thumbnails.wait();
    EXPECT_EQ(thumbnails.picture("no such preset", 16), nullptr);
    EXPECT_TRUE(thumbnails.idle());
}

TEST(EditThumbnails, MayBeLeftWhileTheyAreMade) {
    EditThumbnails thumbnails([] {});
    for (const char* preset : {"wood", "marble", "clouds", "fire"}) thumbnails.picture(preset, 64);
}

}  // namespace
}  // namespace burl
