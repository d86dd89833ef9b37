// What the editor does to recipes: good values become steps, bad ones a sentence and nothing else,
// and the command line that it offers makes the same recipe.
#include "app/editor/session/session.h"
#include "app/recipe/edit/recipe_json.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "app/base/atomic_file.h"
#include "app/base/embedded.h"
#include "app/editor/session/autosave.h"
#include "app/image/image_io.h"
#include "app/recipe/edit/images.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"
#include "atlas/base/real_path.h"
#include "tests/app/support/scratch_folder.h"

namespace burl {
namespace {

EditSession marble_session() {
    return {load_recipe("marble"), "marble"};
}

TEST(EditSession, AValueIsAStep) {
    EditSession session = marble_session();
    const Recipe before = session.recipe();
    EXPECT_TRUE(session.set("texture.input.noise.0.amplitude", 0.75));
    EXPECT_EQ(session.recipe(), load_recipe("marble", {"texture.input.noise.0.amplitude=0.75"}));
    session.history().undo();
    EXPECT_EQ(session.recipe(), before);
}

TEST(EditSession, ARefusedValueChangesNothingAndIsTold) {
    EditSession session = marble_session();
    const Recipe before = session.recipe();
    EXPECT_FALSE(session.set("texture.input.noise.0.octaves", 99));
    EXPECT_FALSE(session.set("texture.input.noise.0.octavse", 2));
    EXPECT_FALSE(session.open_recipe("no-such-recipe"));
    EXPECT_FALSE(session.paste_recipe("{\"burl\": 1"));
    EXPECT_EQ(session.recipe(), before);
    EXPECT_FALSE(session.history().can_undo());
    ASSERT_EQ(session.log().size(), 4u);
    for (const LogLine& line : session.log()) EXPECT_TRUE(line.problem);
    EXPECT_NE(session.log()[0].text.find("octaves"), std::string::npos);
}

/// Or a slider's drag would read them in every frame.
TEST(EditSession, ImagesAreReadWhenTheyChangeOnly) {
    const ScratchFolder folder;
    write_png(folder / "a.png", Image<Rgb8>(2, 2, Rgb8{10, 20, 30}));
    write_png(folder / "b.png", Image<Rgb8>(2, 2, Rgb8{40, 50, 60}));
    write_file(folder / "r.json", R"({"burl": 1, "texture": {"node": "scale", "b": 0.5,
        "a": {"node": "image", "file": "a.png"}}})");
    EditSession session(load_recipe(folder / "r.json"), folder / "r.json");
    const Recipe wanted = load_recipe(folder / "r.json", {"solid.scale=2", "texture.b=0.25"});
    const Recipe other = load_recipe(folder / "r.json", {"texture.a.file=b.png"});
    std::filesystem::remove(folder / "a.png");
    EXPECT_TRUE(session.set({"solid.scale=2", "texture.b=0.25"}));
    EXPECT_EQ(session.recipe(), wanted);
    session.history().undo();
    EXPECT_TRUE(session.set("texture.a.file", "b.png"));
    EXPECT_EQ(session.recipe(), other);
    EXPECT_FALSE(session.set("texture.a.file", "a.png"));
    EXPECT_FALSE(session.set("texture.b", "no number"));
}

TEST(EditSession, WhatWasTouchedIsForgottenWithItsRecipe) {
    EditSession session(load_recipe("windy"), "windy");
    session.touch("texture.input.b.b.octaves");
    EXPECT_EQ(session.touched(), "texture.input.b.b.octaves");
    session.set("texture.input.b.b.octaves", 2);
    EXPECT_EQ(session.touched(), "texture.input.b.b.octaves");
    ASSERT_TRUE(session.open_recipe("checks"));
    EXPECT_EQ(session.touched(), "");
    session.touch("solid.scale");
    session.history().undo();
    EXPECT_EQ(session.touched(), "solid.scale");  // which all have
    session.touch("texture.input.noise.7.amplitude");
    EXPECT_EQ(session.touched(), "");
}

TEST(EditSession, UndoBringsBackTheFileThatIsSavedTo) {
    const ScratchFolder folder;
    const std::string file = folder / "theirs.json";
    const std::string theirs = to_json(load_recipe("wood"));
    write_file(file, theirs);
    EditSession session = marble_session();
    ASSERT_TRUE(session.open_recipe(file));
    EXPECT_EQ(session.recipe_path(), file);
    session.history().undo();
    EXPECT_EQ(session.recipe_path(), "marble");
    EXPECT_FALSE(session.history().changed());
}

TEST(EditSession, AnEditThatCannotBeMadeIsTold) {
    EditSession session = marble_session();
    EXPECT_FALSE(session.change_with([]() -> Recipe { throw Error(ExitCode::usage, "no"); }));
    EXPECT_EQ(session.log().back().text, "no");
    EXPECT_FALSE(session.history().can_undo());
}

TEST(EditSession, SavesWhatOpensToTheSameRecipe) {
    const ScratchFolder folder;
    EditSession session = marble_session();
    session.set("solid.scale", 2.5);
    EXPECT_TRUE(session.history().changed());
    const std::string path = folder / "mine.json";
    session.save_recipe(path);
    EXPECT_FALSE(session.history().changed());
    EditSession other = marble_session();
    ASSERT_TRUE(other.open_recipe(path));
    EXPECT_EQ(other.recipe(), session.recipe());
    EXPECT_FALSE(other.history().changed());
    other.history().undo();
    EXPECT_EQ(other.recipe(), load_recipe("marble"));
}

constexpr const char* pictured_json = R"({"burl": 1, "texture": {"node": "scale", "b": 0.5,
    "a": {"node": "image", "file": "images/a.png"}}})";

/// A folder "old" that has the recipe r.json and its image, and a folder "new".
class EditSessionImages : public testing::Test {
  protected:
    EditSessionImages() {
        std::filesystem::create_directories(folder / "old/images");
        std::filesystem::create_directory(folder / "new");
        for (const char* name : {"old/images/a.png", "old/images/b.png"})
            write_png(folder / name, Image<Rgb8>(2, 2, Rgb8{10, 20, 30}));
        write_file(file, pictured_json);
    }
    static std::string name_in(const Recipe& recipe) { return recipe.texture.images.at(0).file; }

    ScratchFolder folder;
    std::string file = folder / "old/r.json", moved = folder / "new/r.json";
};

TEST_F(EditSessionImages, AreFoundFromAnotherFolder) {
    EditSession session(load_recipe(file), file);
    ASSERT_TRUE(session.set("texture.b", 0.25));
    session.save_recipe(moved);
    EXPECT_EQ(name_in(session.recipe()), "../old/images/a.png");
    EXPECT_EQ(load_recipe(moved), session.recipe());
    EXPECT_FALSE(session.history().changed());
    EXPECT_EQ(session.history().opened().texture, load_recipe(moved, {"texture.b=0.5"}).texture);
    ASSERT_TRUE(session.set("texture.a.file", "../old/images/b.png")) << session.log().back().text;
    session.history().undo();
    session.history().undo();
    session.save_recipe(moved);
    EXPECT_EQ(load_recipe(moved), session.recipe()) << "steps before have the names, too";
    session.save_recipe(file);
    EXPECT_EQ(name_in(load_recipe(file)), "images/a.png");
}

TEST_F(EditSessionImages, KeepTheirNamesWhereTheyLeadOn) {
    const Recipe recipe = load_recipe(file), absolute = with_absolute_images(recipe, file);
    EXPECT_EQ(name_in(with_images_for(recipe, file, folder / "old/s.json")), "images/a.png");
    EXPECT_EQ(name_in(absolute), real_path(folder / "old/images/a.png"));
    EXPECT_EQ(with_images_for(absolute, file, moved), absolute) << "it is not below that folder";
    EXPECT_EQ(with_images_for(absolute, "", file), recipe);
    std::filesystem::create_directory_symlink(folder / "old/images", folder / "new/link");
    EXPECT_EQ(name_in(with_images_for(recipe, file, folder / "new/link/r.json")), "a.png");
}

TEST_F(EditSessionImages, AreWrappedAnewWhereThatIsEdited) {
    EditSession session(load_recipe(file), file);
    ASSERT_TRUE(session.set("texture.a.wrap", "black"));
    EXPECT_EQ(session.recipe().texture.images.at(0).pixels->wrap(), ImageWrap::black);
}

TEST_F(EditSessionImages, SurviveInTheAutosave) {
    const std::string autosave = folder / "state/autosave.json";
    EditSession session(load_recipe(file), file);
    ASSERT_TRUE(session.set("texture.b", 0.25));
    EditAutosave(autosave).keep(session.history(), 0.0);
    EditAutosave next(autosave);
    ASSERT_EQ(next.left_behind().size(), 1u);
    EditSession later = marble_session();
    ASSERT_TRUE(later.recover_recipe(next.left_behind()[0].json, autosave));
    later.save_recipe(file);
    EXPECT_EQ(load_recipe(file), session.recipe());
}

TEST(EditSession, SettingsBetweenRecipesMakeOneOfTheOther) {
    const Recipe base = load_recipe("marble");
    const std::vector<std::string> edits{
        "solid.scale=3", "texture.input.noise.0.frequency=[1,2,3]",
        "texture.stops=[[0,\"#000000\"],[0.5,\"#ff0000\"],[1,\"#ffffff\"]]", "filter.kind=exact",
        "name=mine"};
    const Recipe recipe = load_recipe("marble", edits);
    const RecipeSettings between = settings_between(base, recipe);
    ASSERT_TRUE(between.possible);
    EXPECT_EQ(between.settings.size(), edits.size());
    EXPECT_EQ(load_recipe("marble", between.settings), recipe);
    EXPECT_TRUE(settings_between(base, base).settings.empty());
    EXPECT_FALSE(settings_between(base, load_recipe("cloudy-planet")).possible);
}

TEST(EditSession, TheCommandLineIsQuotedForAShell) {
    const Recipe base = load_recipe("marble");
    const Recipe recipe = load_recipe("marble", {"name=it's", "solid.scale=3"});
    EXPECT_EQ(bake_command("my mesh.obj", "marble", base, recipe),
              "burl bake 'my mesh.obj' -o 'it'\\''s.glb' --recipe marble --set "
              "'name=\"it'\\''s\"' --set solid.scale=3.0");
}

TEST(EditSession, TheCommandLineLeavesOutWhatTheBakeHasNoUseFor) {
    const Recipe base = load_recipe("marble");
    const auto command = [&](const std::vector<std::string>& edits, const std::string& pose) {
        return bake_command("m.obj", "marble", base, load_recipe("marble", edits), {"-o", "a.glb"},
                            pose);
    };
    // What was touched while the atlas was quad, and the pose of another mesh.
    const std::vector<std::string> touched{"atlas.gutter=2", "pose.weight=0.5", "solid.scale=3"};
    EXPECT_EQ(command(touched, ""),
              "burl bake m.obj -o a.glb --recipe marble --set solid.scale=3.0");
    EXPECT_NE(command(touched, "nodes").find("0.5"), std::string::npos);
    EXPECT_NE(command({"atlas.gutter=2", "atlas.kind=quad"}, "").find("--set atlas.gutter=2"),
              std::string::npos);
}

TEST(EditSession, SettingsLeavePaintAlone) {
    EditSession session(load_recipe("marble", {"paint.0.points=[[1,2,3]]"}), "marble");
    const std::vector<PaintStroke> paint = session.recipe().paint;
    ASSERT_EQ(paint.size(), 1u);
    EXPECT_TRUE(session.set("solid.scale", 7.0));
    EXPECT_EQ(session.recipe().paint, paint);
    EXPECT_EQ(session.recipe().solid.scale, 7.0);
    EXPECT_TRUE(session.set("paint.0.radius", 0.5));
    EXPECT_EQ(session.recipe().paint[0].radius, 0.5);
    EXPECT_EQ(session.recipe().paint[0].points, paint[0].points);
}

TEST(BakeCommand, NamesTheSavedRecipeWhereStrokesOfPaintAreMany) {
    const Recipe base = load_recipe("marble");
    Recipe recipe = base;
    recipe.paint.resize(1);
    recipe.paint[0].points = {{0.0, 0.25, 0.5}, {0.1, 0.25, 0.5}};
    const RecipeSettings few = settings_between(base, recipe);
    EXPECT_EQ(parse_recipe(to_json(base), "base", few.settings), recipe);
    EXPECT_NE(bake_command("m.obj", "marble", base, recipe).find("--set 'paint=["),
              std::string::npos);
    recipe.paint.resize(100);
    EXPECT_EQ(bake_command("m.obj", "marble", base, recipe),
              "burl bake m.obj -o marble.glb --recipe marble.json");
}

}  // namespace
}  // namespace burl
