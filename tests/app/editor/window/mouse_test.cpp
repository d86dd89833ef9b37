// The editor in a window of a display (Xvfb), used with a real mouse and keyboard: every event goes
// through the X server. Nothing here waits for a time: each step goes on once the editor shows what
// the step is to bring about.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "app/base/file_bytes.h"
#include "app/editor/panels/parameters.h"
#include "app/editor/window/program.h"
#include "app/pipeline/pipeline.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/surface/sample_meshes.h"
#include "tests/app/edit/oak_steps.h"
#include "tests/app/programs/run_program.h"
#include "tests/app/support/x_display.h"

namespace burl {
namespace {

using test::XHand;

constexpr std::chrono::seconds patience{90};
constexpr double step = 7.0;  // pixels between two moves of a drag

/// The editor and whoever sits before it.
class Person {
  public:
    Person(const XHand& hand, const EditorOptions& options) : hand_(hand) {
        editor =
            std::make_unique<EditorProgram>(create_desktop_window({1000, 800}, "Burl"), options);
        test::keep_libraries();
        settle();
    }

    /// Lets the editor go on until it shows what is awaited; false, and a failed test, where that
    /// does not come.
    template <class Awaited>
    bool until(const std::string& what, const Awaited& awaited) {
        const auto end = std::chrono::steady_clock::now() + patience;
        while (!awaited()) {
            if (std::chrono::steady_clock::now() > end) {
                ADD_FAILURE() << "in vain: " << what;
                return false;
            }
            editor->turn();
        }
        return true;
    }

    void settle() {
        until("the finest texture", [&] {
            const EditPicture* shown = editor->shown();
            return editor->settled() && shown && shown->request == editor->last_request() &&
                   shown->level == 0;
        });
    }

    void move(const glm::dvec2& to) {
        const glm::dvec2 at(std::floor(to.x), std::floor(to.y));
        hand_.move(at);
        until("the pointer", [&] {
            const ImVec2 there = ImGui::GetIO().MousePos;
            return double(there.x) == at.x && double(there.y) == at.y;
        });
    }

    void press(bool down, int number = 0) {
        hand_.button(number == 0 ? 1 : 3, down);
        until("the button", [&] { return ImGui::GetIO().MouseDown[number] == down; });
    }

    void move_to(const std::string& item) {
        if (until(item, [&] { return editor->items().find(item).has_value(); }))
            move(editor->items().find(item)->middle());
    }

    void click(const std::string& item, int number = 0) {
        move_to(item);
        press(true, number);
        press(false, number);
    }

    void drag(const std::string& item, double by) {
        move_to(item);
        const glm::dvec2 from = editor->items().find(item)->middle();
        press(true);
        for (double moved = 0.0; moved != by;) {
            moved = by > 0.0 ? std::min(moved + step, by) : std::max(moved - step, by);
            move(from + glm::dvec2(moved, 0.0));
        }
        press(false);
        settle();
    }

    /// "Control_L" and such held meanwhile.
    void key(const std::string& name, const std::string& held = "") {
        const int frames = ImGui::GetFrameCount();
        if (!held.empty()) hand_.key(held, true);
        hand_.key(name, true);
        hand_.key(name, false);
        if (!held.empty()) hand_.key(held, false);
        until("all keys up", [&] {
            const ImGuiIO& io = ImGui::GetIO();
            return ImGui::GetFrameCount() > frames + 1 && !io.KeyCtrl &&
                   std::ranges::none_of(io.KeysDown, [](bool down) { return down; });
        });
    }

    /// Into the file dialog that a shortcut opens.
    void choose_file(const std::string& letter, const std::string& path) {
        key(letter, "Control_L");
        name_file(path);
    }

    /// Into the one that is open.
    void name_file(const std::string& path) {
        click("file name");
        key("a", "Control_L");
        hand_.type(path);
        key("Return");
        until("the dialog's end", [&] { return !editor->items().find("file name").has_value(); });
    }

    /// Like undo: the recipe is another one at once.
    void undo() { key("z", "Control_L"); }
    void redo() { key("y", "Control_L"); }

    const Recipe& recipe() const { return editor->session().recipe(); }

    /// The object, the pointer being elsewhere and all at rest.
    Image<Rgb8> picture() {
        move({2.0, 2.0});
        settle();
        for (int i = 0; i < 4; ++i) editor->frame({});
        const Image<Rgb8> screen = editor->screenshot();
        const ItemRect object = editor->items().find("object").value();
        const auto top = std::size_t(object.low.y), high = std::size_t(object.high.y) - top;
        Image<Rgb8> shown(std::size_t(object.high.x), high);
        for (std::size_t y = 0; y < high; ++y)
            std::ranges::copy(screen.row(top + y).first(shown.width()), shown.row(y).begin());
        return shown;
    }

    std::unique_ptr<EditorProgram> editor;

  private:
    const XHand& hand_;
};

class GlEditMouseTest : public testing::Test {
  protected:
    void SetUp() override {
        if (std::system("command -v Xvfb >/dev/null") != 0) GTEST_SKIP() << "Xvfb is not installed";
        server = std::make_unique<test::XServer>("1300x900x24");
        ASSERT_FALSE(server->display().empty()) << "Xvfb did not start";
        hand = std::make_unique<XHand>(server->display());
        if (!hand->problem().empty()) GTEST_SKIP() << hand->problem();
        setenv("DISPLAY", server->display().c_str(), 1);
        unsetenv("WAYLAND_DISPLAY");
    }

    static EditorOptions options(const std::string& mesh, const std::string& recipe) {
        EditorOptions options;
        options.light = "headlight";  // an environment takes longer to prepare than most tests
        options.mesh = mesh;
        options.recipe = recipe;
        options.gallery = false;
        return options;
    }

    test::Scratch scratch;
    std::unique_ptr<test::XServer> server;
    std::unique_ptr<XHand> hand;
};

const RecipeLeaf& leaf(const std::vector<RecipeLeaf>& leaves, const std::string& path) {
    return *std::ranges::find(leaves, path, &RecipeLeaf::path);
}

/// Drags a slider from its middle and compares the value with where the pointer was let go; what is
/// grabbed takes a part of the width, which leaves a doubt.
void drag_slider(Person& person, const std::string& path, double by) {
    const auto before = recipe_leaves(slider_json(person.recipe()));
    const double value = leaf(before, path).value.get<double>();
    const SliderRange range = slider_range(*leaf(before, path).parameter, value);
    person.until(path, [&] { return person.editor->items().find(path).has_value(); });
    const ItemRect item = person.editor->items().find(path).value();
    person.drag(path, by);
    const double share = 0.5 + by / (item.high.x - item.low.x);
    const auto after = recipe_leaves(slider_json(person.recipe()));
    EXPECT_NEAR(leaf(after, path).value.get<double>(), range.low + (range.high - range.low) * share,
                0.06 * (range.high - range.low))
        << path;
}

const std::string noise = "texture.input.noise.0.";

/// A change of the recipe by each way there is; the recipe after each.
std::vector<Recipe> change_all(Person& person) {
    std::vector<Recipe> steps{person.recipe()};
    const auto changed = [&](const std::string& what) {
        person.until(what, [&] { return person.recipe() != steps.back(); });
        person.settle();
        steps.push_back(person.recipe());
    };
    person.click("tab:Parameters");
    const std::vector<std::pair<std::string, double>> drags{
        {noise + "amplitude", 31.0}, {noise + "octaves", -47.0}, {"solid.scale", -40.0}};
    for (const auto& [path, by] : drags) {
        drag_slider(person, path, by);
        changed(path);
    }
    person.click(noise + "kind");
    person.click(noise + "kind=perlin");
    changed("a noise from the list");
    person.click("tab:Colours");
    person.click("texture.wrap");
    changed("the box for repeating");
    person.drag("texture.stops.2", 25.0);
    changed("a stop's place");
    person.click("texture.bar");
    changed("a stop more");
    person.click("texture.stops.1", 1);
    changed("a stop less");
    return steps;
}

void undo_and_redo(Person& person, const std::vector<Recipe>& steps) {
    EditHistory& history = person.editor->session().history();
    for (std::size_t i = steps.size() - 1; i-- > 0;) {
        person.undo();
        person.until("undone", [&] { return person.recipe() == steps[i]; });
    }
    for (std::size_t i = 1; i < steps.size(); ++i) {
        EXPECT_TRUE(history.can_redo());
        person.redo();
        person.until("redone", [&] { return person.recipe() == steps[i]; });
    }
    EXPECT_FALSE(history.can_redo());
}

TEST_F(GlEditMouseTest, OpensDragsUndoesSavesAndOpensAgain) {
    const std::vector<std::string> small{"atlas.size=64", "atlas.tries=1"};
    EditSession(load_recipe("wood", small), "").save_recipe(scratch / "wood.json");
    EditSession(load_recipe("marble", small), "").save_recipe(scratch / "marble.json");
    const std::string mesh = scratch / "torus.obj", saved = scratch / "Mine_1.json";
    std::filesystem::copy_file(test::mesh_folder() + "/torus.obj", mesh);
    Image<Rgb8> last;
    Recipe recipe;
    {
        Person person(*hand, options("sample:cube", scratch / "wood.json"));
        EditorProgram& editor = *person.editor;
        const Image<Rgb8> cube = person.picture();
        // A mesh by the dialog; a recipe by a drop, which the X test extension has not.
        person.choose_file("o", mesh);
        person.until("the torus", [&] {
            return editor.baker().front().surface()->triangles ==
                   sample_mesh("sample:torus").triangles.size();
        });
        InputEvent drop{InputKind::drop};
        drop.files = {scratch / "marble.json"};
        editor.frame({drop});
        const Recipe marble = load_recipe("marble", small);
        person.until("the marble", [&] { return person.recipe() == marble; });
        const Image<Rgb8> first = person.picture();
        EXPECT_FALSE(first == cube);

        const std::vector<Recipe> steps = change_all(person);
        last = person.picture();
        EXPECT_FALSE(last == first);
        undo_and_redo(person, steps);
        EXPECT_TRUE(person.picture() == last);

        recipe = person.recipe();
        person.click("menu:File");
        person.click("menu:Save recipe as...");
        person.name_file(saved);
        person.until("the file", [&] { return std::filesystem::exists(saved); });
        EXPECT_EQ(load_recipe(saved), recipe);
        EXPECT_FALSE(editor.session().history().changed());
        person.click("menu:File");
        person.click("menu:Quit");
        person.until("the end", [&] { return editor.wants_to_close(); });
    }
    Person again(*hand, options(mesh, saved));
    EXPECT_EQ(again.recipe(), recipe);
    EXPECT_TRUE(again.picture() == last);
}

/// The object's part of the screen.
Image<Rgb8> object_of(EditorProgram& editor) {
    const Image<Rgb8> screen = editor.screenshot();
    const ItemRect rect = editor.items().find("object").value();
    Image<Rgb8> part(std::size_t(rect.high.x - rect.low.x), std::size_t(rect.high.y - rect.low.y));
    for (std::size_t y = 0; y < part.height(); ++y)
        std::ranges::copy(
            screen.row(std::size_t(rect.low.y) + y).subspan(std::size_t(rect.low.x), part.width()),
            part.row(y).begin());
    return part;
}

TEST_F(GlEditMouseTest, OakIsBuiltFromNothingInAWindowAsWithoutOne) {
    const auto bytes = read_file_bytes(test::source_folder() + "/docs/images/editor-oak.json");
    const std::string script(bytes.begin(), bytes.end());
    EditorOptions small = options("sample:cube", "marble");
    small.settings = {"atlas.size=64", "atlas.tries=1"};
    const Recipe oak = test::built_oak(load_recipe("marble", small.settings)).recipe;
    const auto built = [&](std::unique_ptr<GlWindow> window) {
        EditorProgram editor(std::move(window), small);
        test::keep_libraries();
        editor.play(parse_script(script, "oak"), "");
        EXPECT_EQ(editor.session().recipe(), oak);
        Pipeline pipeline(load_mesh("sample:cube"));
        pipeline.set_recipe(oak);
        EXPECT_EQ(editor.shown()->texels, pipeline.synthesize<Rgb8>());
        return object_of(editor);
    };
    const Image<Rgb8> seen = built(create_desktop_window({1280, 800}, "Burl"));
    const Image<Rgb8> unseen = built(create_unseen_window(create_osmesa_context(), {1280, 800}));
    ASSERT_EQ(seen.width(), unseen.width());
    ASSERT_EQ(seen.height(), unseen.height());
    double squares = 0.0;
    std::set<std::array<int, 3>> colors;
    for (std::size_t y = 0; y < seen.height(); ++y)
        for (std::size_t x = 0; x < seen.width(); ++x) {
            const Rgb8 a = seen(x, y), b = unseen(x, y);
            squares += std::pow(a.r - b.r, 2) + std::pow(a.g - b.g, 2) + std::pow(a.b - b.b, 2);
            colors.insert({a.r, a.g, a.b});
        }
    EXPECT_GT(colors.size(), 1000u) << "the wood is to be seen";
    EXPECT_LT(std::sqrt(squares / (3.0 * double(seen.width() * seen.height()))), 0.5)
        << "codes, between two builds of software OpenGL";
}

}  // namespace
}  // namespace burl
