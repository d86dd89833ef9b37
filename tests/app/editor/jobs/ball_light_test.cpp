// Thumbnails and node balls in the light that was chosen: one prefiltered environment for all, and
// new pictures when it changes.
#include <gtest/gtest.h>

#include "app/direct/picture.h"
#include "app/editor/jobs/node_pictures.h"
#include "app/editor/jobs/thumbnails.h"
#include "app/image/image_diff.h"
#include "app/recipe/edit/recipe_json.h"

namespace burl {
namespace {

BallLight light_of(const char* name) {
    return std::make_shared<const PrefilteredLight>(prefilter(make_environment(name, 64), 64));
}

/// The picture of `burl render --direct --rays 0`, with the environment's own 256 rows.
Image<Rgb8> rendered(const std::string& recipe, const std::string& light, int side) {
    DirectOptions options;
    options.scene = "sample:icosphere";
    options.view = "50,25,3.5";
    options.size = std::to_string(side) + "x" + std::to_string(side);
    options.light.light = light;
    options.filter = "trapezoid";
    options.rays = 0;
    return DirectPicture(options)({load_recipe(recipe), {}});
}

TEST(BallLight, IsTheEnvironmentThatBurlRenderDraws) {
    const auto light =
        std::make_shared<const PrefilteredLight>(prefilter(make_environment("dusk")));
    DirectOptions options;
    options.scene = "sample:icosphere";
    options.view = "50,25,3.5";
    options.size = "40x40";
    options.filter = "trapezoid";
    const Image<Rgb8> shared = DirectPicture(options, light)({load_recipe("gold"), {}});
    EXPECT_EQ(shared, rendered("gold", "dusk", 40));
    EXPECT_LT(diff_images(shared, rendered("gold", "studio", 40)).psnr_db, 30.0);
}

TEST(BallLight, ChangesThumbnailsWhichStayUntilThen) {
    EditThumbnails thumbnails([] {});
    thumbnails.picture("gold", 16);
    thumbnails.wait();
    const auto head = thumbnails.picture("gold", 16);
    ASSERT_NE(head, nullptr);
    const BallLight studio = light_of("studio");
    thumbnails.set_light(studio);
    EXPECT_EQ(thumbnails.picture("gold", 16), head) << "until the new one is there";
    thumbnails.wait();
    const auto lit = thumbnails.picture("gold", 16);
    ASSERT_NE(lit, nullptr);
    EXPECT_EQ(*lit, ball_picture(load_recipe("gold"), 16, "trapezoid", studio));
    EXPECT_NE(*lit, *head);
    EXPECT_TRUE(thumbnails.idle()) << "it is not made again";
    thumbnails.set_light(nullptr);
    thumbnails.picture("gold", 16);
    thumbnails.wait();
    EXPECT_EQ(*thumbnails.picture("gold", 16), *head);
}

/// Thumbnails in view come first: those of the old light that nobody asks for again are not made.
TEST(BallLight, DropsThumbnailsThatWaitInAnotherLight) {
    EditThumbnails thumbnails([] {});
    thumbnails.hold(true);
    for (const char* preset : {"wood", "marble", "clouds"}) thumbnails.picture(preset, 16);
    thumbnails.set_light(light_of("studio"));
    thumbnails.picture("gold", 16);
    thumbnails.hold(false);
    thumbnails.wait();
    EXPECT_NE(thumbnails.picture("gold", 16), nullptr);
    EXPECT_EQ(thumbnails.picture("wood", 16), nullptr);
    thumbnails.wait();
    EXPECT_NE(thumbnails.picture("wood", 16), nullptr);
}

TEST(BallLight, ChangesTheBallsOfNodes) {
    NodePictures pictures([] {});
    const Recipe recipe = parse_recipe(
        R"({"burl": 1, "texture": {"node": "mix", "a": "#c08040", "b": "#204080",
            "amount": {"node": "fbm"}}})",
        "test");
    const auto drawn = [&] {
        pictures.request(recipe, "", {"texture"}, 32);
        pictures.wait();
        return pictures.picture("texture");
    };
    const NodePictures::Picture head = drawn();
    ASSERT_NE(head, nullptr);
    EXPECT_EQ(drawn(), head);
    pictures.set_light(light_of("studio"));
    EXPECT_EQ(pictures.picture("texture"), head);
    const NodePictures::Picture studio = drawn();
    EXPECT_NE(*studio, *head);
    pictures.set_light(nullptr);
    EXPECT_EQ(*drawn(), *head);
}

}  // namespace
}  // namespace burl
