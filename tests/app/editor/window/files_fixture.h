#pragma once
// A fixture for an editor that opens files of the test's own folder.
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/base/atomic_file.h"
#include "app/base/file_bytes.h"
#include "app/recipe/edit/recipe_json.h"
#include "tests/app/editor/window/fixture.h"
#include "tests/app/support/scratch_folder.h"

namespace burl {

class GlEditFilesTest : public GlEditProgramTest {
  protected:
    /// Starts an editor; thumbnails (`gallery`) take longer than most tests.
    std::unique_ptr<EditorProgram> open(const std::string& mesh, const std::string& recipe,
                                        bool gallery = false) {
        EditorOptions options;
        options.light = "headlight";  // an environment takes longer to prepare than most tests
        options.mesh = mesh;
        options.recipe = recipe;
        options.recent = folder / "recent";
        options.gallery = gallery;
        options.autosave = folder / "autosave.json";
        auto editor = std::make_unique<EditorProgram>(
            create_unseen_window(create_test_context(), {800, 640}), options);
        play(*editor, settle);
        return editor;
    }
    /// Writes a preset with one changed setting as the recipe file `name`.
    void save(const std::string& recipe, const std::string& setting = "solid.scale=1",
              const std::string& name = "r.json") const {
        write_file(folder / name,
                   to_json(load_recipe(recipe, {"atlas.size=64", "atlas.tries=1", setting})));
    }
    /// Returns the names of the files "out...".
    std::vector<std::string> outputs() const {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
            if (entry.path().filename().string().starts_with("out"))
                names.push_back(entry.path().filename());
        return names;
    }
    /// Returns script steps that drop a file on the editor.
    static std::string dropped(const std::string& path) {
        return R"({"drop": [")" + path + R"("]}, {"settle": true}, {"wait": 2})";
    }
    std::string text(const std::string& name) const {
        const auto bytes = read_file_bytes(folder / name);
        return {bytes.begin(), bytes.end()};
    }
    static std::size_t triangles(const EditorProgram& editor) {
        return editor.baker().front().surface()->triangles;
    }

    static constexpr const char* settle = R"({"settle": true}, {"wait": 2})";
    ScratchFolder folder;
};

}  // namespace burl
