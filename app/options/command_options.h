#pragma once
// Options that several verbs share, so that a recipe or an atlas is named the same way everywhere.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/recipe/images.h"
#include "app/recipe/recipe.h"
#include "atlas/read/read_mesh.h"
#include "procedural/batch/kernel.h"

namespace CLI {
class App;
class Validator;
}  // namespace CLI

namespace burl {

/// An edit of a recipe on the command line.
struct RecipeEdit {
    std::string said;  ///< as it was given: "--size 64"
    std::string path, value;

    std::string setting() const { return path + "=" + value; }
};

/// --recipe, --set, --time and the atlas options; the latter are edits of the recipe like any
/// --set.
struct RecipeOptions {
    std::string recipe = "marble";
    std::vector<std::string> settings;
    std::optional<std::string> kind, overscan, weight, tries, partition, gutter, diagonals, filter,
        precision, size;
    std::optional<double> time;  ///< of a recipe with keys, in seconds; left out: 0
    /// Copies of the options, one for every frame, share the images they read.
    std::shared_ptr<RecipeImages> images = std::make_shared<RecipeImages>();

    void add_recipe(CLI::App& verb);
    /// --set and --time alone, for verbs that take the recipe as an argument.
    void add_settings(CLI::App& verb);
    void add_atlas(CLI::App& verb);
    /// --precision, with what is computed if it is left out.
    void add_precision(CLI::App& verb, const std::string& otherwise);
    /// Every edit, those of --set first.
    std::vector<RecipeEdit> edits() const;
    /// The recipe with all edits applied; throws Error as load_recipe does, and usage for what is
    /// said twice or moved by the recipe's own keys.
    Recipe load_keyed() const;
    /// The recipe at `time` (recipe_at), without keys. Throws Error(usage) for a `time` where there
    /// are no keys.
    Recipe load() const;
};

/// "float32", "float64" or "fixed:8.8"; throws Error(usage) for anything else.
Precision parse_precision(const std::string& text);

/// --weld and --unshare-instances.
struct MeshOptions {
    ReadOptions read;

    void add(CLI::App& verb);
    /// Reads the mesh, or makes the sample ("sample:teapot"), and prints what reading noticed on
    /// stderr.
    Mesh load(const std::string& path) const;
};

/// --pose (app/surface/load_pose.h).
void add_pose(CLI::App& verb, std::string& pose);

/// A number within bounds; CLI::Range would let NaN pass.
CLI::Validator in_range(double low, double high);
/// One of the words; of a misspelt one it says which was probably meant.
CLI::Validator one_of(const std::vector<std::string>& words);

/// --threads, 0 for all.
void add_threads(CLI::App& verb, int& threads);
/// The --kernel that sums differences (app/recipe/forward_check.h), whose result is another one.
inline constexpr const char* forward_kernel = "forward";
/// The --kernel that is another name for --precision float64.
inline constexpr const char* reference_kernel = "reference";
/// --kernel, one of kernel_names, forward_kernel or reference_kernel.
void add_kernel(CLI::App& verb, std::string& kernel);
/// Sets the precision that --kernel reference stands for. Throws Error(usage) if the recipe asks
/// for another.
void apply_reference(Recipe& recipe);
/// `automatic` for any other name.
Kernel kernel_named(const std::string& name);

/// One line per thing reading noticed, with the file's name in front.
void print_notes(const std::string& path, const MeshNotes& notes);

}  // namespace burl
