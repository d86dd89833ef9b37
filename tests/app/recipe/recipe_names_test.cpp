// Lists and patterns of recipes' names.
#include "app/recipe/recipe_names.h"

#include <gmock/gmock.h>

#include "app/recipe/presets.h"
#include "atlas/base/error.h"

namespace burl {
namespace {

TEST(RecipeNames, AreTakenInTheirOrderEachOnce) {
    EXPECT_THAT(recipes_named({"walnut,oak", "my/own.json,oak"}),
                testing::ElementsAre("walnut", "oak", "my/own.json"));
}

TEST(RecipeNames, PatternsFitPresetsThenMaterials) {
    const std::vector<std::string> granites = recipes_named({"granite-pink,granite*"});
    EXPECT_THAT(granites, testing::ElementsAre("granite-pink", "granite-grey"));
    EXPECT_THAT(recipes_named({"o?k"}), testing::ElementsAre("oak"));
    EXPECT_EQ(recipes_named({"*"}).size(), preset_names().size() + material_names().size());
    for (const std::string& name : recipes_named({"*marble*"}))
        EXPECT_THAT(name, testing::HasSubstr("marble"));
    EXPECT_THAT(recipes_named({"*marble*"}), testing::Contains("marble"));
}

TEST(RecipeNames, RefuseWhatNamesNothing) {
    for (const char* bad : {"", "oak,", ",oak", "oak,,walnut", "zz*"})
        EXPECT_THROW(recipes_named({bad}), Error) << bad;
}

}  // namespace
}  // namespace burl
