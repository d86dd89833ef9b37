#pragma once
// A fixture for tests that use the editor as a person does, without a display: scripts of real
// pointer and key events.
#include <memory>
#include <string>

#include "app/editor/window/program.h"
#include "tests/app/gl/device/fixture.h"

namespace burl {

class GlEditProgramTest : public GlTest {
  protected:
    std::unique_ptr<EditorProgram> start(const std::string& recipe = "marble",
                                         const std::string& autosave = "") {
        EditorOptions options;
        options.light = "headlight";  // an environment takes longer to prepare than most tests
        options.mesh = "sample:cube";
        options.recipe = recipe;
        options.settings = {"atlas.size=64", "atlas.tries=1"};
        options.autosave = autosave;
        options.gallery = false;  // thumbnails take longer than most tests
        if (!context) context = create_test_context();
        auto editor = std::make_unique<EditorProgram>(
            create_unseen_window(std::move(context), {800, 640}), options);
        play(*editor, R"({"settle": true}, {"wait": 2})");
        return editor;
    }

    /// Plays steps given as JSON, separated by commas.
    static void play(EditorProgram& editor, const std::string& steps,
                     const std::string& folder = "") {
        editor.play(
            parse_script(R"({"burl_input": 1, "size": [800, 640], "steps": [)" + steps + "]}",
                         "test"),
            folder);
    }

    /// Returns the screen once no background work is left and the pointer is in the corner.
    static Image<Rgb8> settled(EditorProgram& editor) {
        play(editor, R"({"events": [{"move": [1, 1]}]}, {"settle": true}, {"wait": 3})");
        return editor.screenshot();
    }

    /// Returns the number of pixels of the settled screen that differ from `before`, but for the
    /// buttons of undo and redo, which tell what there is to take back.
    static std::size_t different(EditorProgram& editor, const Image<Rgb8>& before) {
        Image<Rgb8> now = settled(editor);
        for (const char* button : {"tool:Undo", "tool:Redo"})
            if (const auto rect = editor.items().find(button))
                for (auto y = std::size_t(rect->low.y); y < std::size_t(rect->high.y); ++y)
                    for (auto x = std::size_t(rect->low.x); x < std::size_t(rect->high.x); ++x)
                        now(x, y) = before(x, y);
        return differing(before, now);
    }
};

}  // namespace burl
