// Pictures of nodes that read masks: on the object itself, against the mask's closed form.
#include "app/editor/jobs/mesh_picture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/editor/jobs/node_pictures.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/scene/shading.h"
#include "procedural/color/srgb.h"

namespace burl {
namespace {

Recipe recipe_of(const std::string& texture) {
    return parse_recipe(R"({"burl": 1, "texture": )" + texture + "}", "test");
}

/// The linear light of a pixel.
double light_at(const Image<Rgb8>& picture, std::size_t x, std::size_t y) {
    return srgb_decode(picture(x, y).g / 255.0);
}

TEST(MeshPicture, ABallIsAsBrightAsItIsHigh) {
    // Seen from 20 degrees above, at 30 degrees: the picture's vertical middle line.
    const MeshPictures ball("sample:icosphere");
    const Image<Rgb8> high = ball.picture(recipe_of(R"({"node": "height_in_box"})"), 64);
    const Image<Rgb8> white = ball.picture(recipe_of(R"({"node": "constant", "value": 1})"), 64);
    double last = 1.0;
    for (std::size_t y = 12; y < 52; ++y) {
        const double value = light_at(high, 32, y) / light_at(white, 32, y);
        EXPECT_LE(value, last + 0.01) << y;
        last = value;
    }
    // In the middle the eye looks at the point in its direction: sin 20 degrees high.
    EXPECT_NEAR(light_at(high, 32, 32) / light_at(white, 32, 32), 0.5 + 0.5 * std::sin(0.349),
                0.03);
    EXPECT_NEAR(light_at(white, 32, 32), 1.0, 0.01) << "the headlight";
    EXPECT_EQ(white(1, 1), high(62, 62)) << "beside the object";
}

TEST(MeshPicture, NumbersThatAreNoGreysAreStretched) {
    const MeshPictures ball("sample:icosphere");
    const std::string facing = R"({"node": "facing", "direction": [0, 1, 0]})";
    const Image<Rgb8> plain = ball.picture(recipe_of(facing), 32);
    const Image<Rgb8> far =
        ball.picture(recipe_of(R"({"node": "add", "b": 7, "a": )" + facing + "}"), 32);
    EXPECT_EQ(plain, far) << "from the least to the largest";
    EXPECT_GT(light_at(plain, 16, 4), 0.5);
    EXPECT_LT(light_at(plain, 16, 26), 0.35);
}

TEST(MeshPicture, ANodeThatReadsAMaskIsDrawnOnTheMesh) {
    NodePictures pictures([] {});
    Recipe recipe = recipe_of(R"({"node": "blend", "base": "#000000", "top": "#ffffff",
        "mask": {"node": "paint", "layer": 3}})");
    PaintStroke stroke;
    stroke.points = {{0.0, 0.0, 0.0}};
    stroke.radius = 2.0, stroke.hardness = 1.0, stroke.layer = 3;
    pictures.request(recipe, "sample:icosphere", {"texture", "texture.mask", "texture.top"}, 32);
    pictures.wait();
    const NodePictures::Picture bare = pictures.picture("texture.mask");
    ASSERT_TRUE(bare && pictures.picture("texture") && pictures.picture("texture.top"));
    EXPECT_EQ((*bare)(16, 16), (Rgb8{0, 0, 0}));
    recipe.paint = {stroke};
    pictures.request(recipe, "sample:icosphere", {"texture"}, 32);
    pictures.wait();
    EXPECT_EQ((*pictures.picture("texture"))(16, 16), (Rgb8{255, 255, 255})) << "painted white";
    pictures.request(recipe, "/no/such/mesh.obj", {"texture"}, 32);
    pictures.wait();
    EXPECT_EQ(pictures.picture("texture"), nullptr);
}

}  // namespace
}  // namespace burl
