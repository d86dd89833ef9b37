// What the editor's views wish for is made, once, and given back when nobody looks.
#include "app/editor/jobs/view_maker.h"
#include "app/recipe/edit/recipe_json.h"

#include <gtest/gtest.h>

#include <atomic>

#include "app/gl/draw/view_scene.h"
#include "tests/atlas/support/made_meshes.h"

namespace burl {
namespace {

class EditViewMakerTest : public testing::Test {
  protected:
    EditViewMakerTest() : pipeline_(made::ball(2)) {
        pipeline_.set_recipe(load_recipe("marble", {"atlas.size=64"}));
        auto surface = std::make_shared<EditSurface>();
        surface->scene = baked_scene(pipeline_);
        auto picture = std::make_shared<EditPicture>();
        picture->texels = pipeline_.synthesize<Rgb8>();
        wish_.lines = surface;
        wish_.sheet = std::make_shared<const AtlasSheet>(atlas_sheet(pipeline_));
        wish_.mode = SheetMode::error;
        wish_.picture = picture;
        wish_.recipe = std::make_shared<const Recipe>(pipeline_.recipe());
    }

    Pipeline pipeline_;
    ViewWish wish_;
    std::atomic<int> wakes_ = 0;
    EditViewMaker maker_{[this] { ++wakes_; }};
};

TEST_F(EditViewMakerTest, MakesWhatIsWishedForOnce) {
    EXPECT_FALSE(maker_.picture());
    maker_.request(wish_);
    maker_.wait();
    ASSERT_TRUE(maker_.picture());
    ASSERT_TRUE(maker_.lines());
    EXPECT_EQ(maker_.picture()->of, wish_);
    EXPECT_EQ(maker_.lines()->edges.size(), 192u);  // 128 triangles
    const auto error =
        texture_error(pipeline_.solid(), pipeline_.recipe(), wish_.picture->texels, {});
    EXPECT_EQ(maker_.picture()->codes, error->codes);
    EXPECT_EQ(maker_.picture()->levels, error_levels(*error));
    const auto lines = maker_.lines();
    wish_.mode = SheetMode::charts;
    maker_.request(wish_);
    maker_.wait();
    EXPECT_EQ(maker_.picture()->levels, sheet_levels(*wish_.sheet, SheetMode::charts));
    EXPECT_EQ(maker_.lines(), lines);
}

TEST_F(EditViewMakerTest, KeepsNothingThatNobodyLooksAt) {
    maker_.request(wish_);
    maker_.wait();
    const std::weak_ptr<const SurfaceLines> lines = maker_.lines();
    const std::weak_ptr<const SheetPicture> picture = maker_.picture();
    maker_.request({});
    maker_.wait();
    EXPECT_TRUE(lines.expired());
    EXPECT_TRUE(picture.expired());
    maker_.request(wish_);
    maker_.request({});  // whether or not it had begun
    maker_.wait();
    EXPECT_FALSE(maker_.picture());
    EXPECT_FALSE(maker_.lines());
}

TEST_F(EditViewMakerTest, SaysWhyThereIsNoReference) {
    Recipe far = pipeline_.recipe();
    far.solid.translate.x = 1e18;
    wish_.recipe = std::make_shared<const Recipe>(far);
    maker_.request(wish_);
    maker_.wait();
    ASSERT_TRUE(maker_.picture());
    EXPECT_TRUE(maker_.picture()->levels.empty());
    EXPECT_NE(maker_.picture()->problem, "");
}

}  // namespace
}  // namespace burl
