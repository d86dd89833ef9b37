#pragma once
// Options that several verbs share, so that recipes and atlases are given the same way everywhere.
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/recipe/edit/images.h"
#include "app/recipe/recipe.h"
#include "app/surface/mesh_frame.h"
#include "atlas/read/read_mesh.h"
#include "procedural/batch/economy.h"

namespace CLI {
class App;
class Validator;
}  // namespace CLI

namespace burl {

/// An edit of a recipe from the command line.
struct RecipeEdit {
    std::string said;  ///< the option as it was given: "--size 64"
    std::string path, value;

    std::string setting() const { return path + "=" + value; }
};

/// The long options of a verb or program, with their dashes.
std::vector<std::string> option_names(const CLI::App& verb);

/// "did you mean WORD? " of the nearest of the words; empty where none is near.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& words);

struct RecipeParameter;

/// An option that sets a parameter of the recipe by itself, such as --size.
struct ParameterOption {
    const RecipeParameter* parameter;
    std::optional<std::string> value{};
};

/// --recipe, --set, --time and the options of the parameter table, which are edits of the recipe
/// as --set is.
struct RecipeOptions {
    std::string recipe = "marble";
    std::vector<std::string> settings;
    /// The options that add_parameters() has added.
    std::vector<ParameterOption> parameters;
    std::optional<std::string> filter, precision;
    /// --time in seconds, for a recipe with keys; 0 where it is left out.
    std::optional<double> time;
    /// The images read so far; copies of the options, one per frame, share them.
    std::shared_ptr<RecipeImages> images =
        std::make_shared<RecipeImages>(ImageLimits{.named = NamedFiles::below});
    double most_noises = 1e13;  ///< --max-noises (app/options/input_limits.h)

    void add_recipe(CLI::App& verb);
    /// Adds --set and --time alone, for verbs that take the recipe as an argument.
    void add_settings(CLI::App& verb);
    /// Adds an option for every parameter that the table gives one: those of the atlas.
    void add_parameters(CLI::App& verb);
    void add_filter(CLI::App& verb);
    /// Adds --precision, whose help calls the default `otherwise`.
    void add_precision(CLI::App& verb, const std::string& otherwise);
    /// The value that a parameter's option was given; empty where the option was left out.
    std::optional<std::string> given(std::string_view path) const;
    /// All edits, those of --set first.
    std::vector<RecipeEdit> edits() const;
    /// The recipe with all edits applied and its keys. Throws Error as load_recipe does, and usage
    /// for a number that is set twice or moved by the recipe's own keys.
    Recipe load_keyed() const;
    /// The recipe at --time (recipe_at), without keys. Throws Error as load_keyed() does, and usage
    /// for --time where the recipe has no keys.
    Recipe load() const;
};

/// Parses "float32", "float64" or "fixed:8.8" (1 to 16 integer bits, 2 to 16 fraction bits). Throws
/// Error(usage) for anything else.
Precision parse_precision(const std::string& text);

/// The options --weld and --unshare-instances, those of the file's axes and units, and those that
/// choose parts of a file.
struct MeshOptions {
    ReadOptions read;
    MeshFrame frame;

    void add(CLI::App& verb);
    /// Adds --uv-set, which says what is read.
    void add_uv_set(CLI::App& verb);
    /// Adds --mesh and --node, which choose parts of a glTF as --material does.
    void add_choice(CLI::App& verb);
    /// Adds --up, --rotate, --scale and --units alone.
    void add_frame(CLI::App& verb);
    /// Throws Error(usage) for options that the format of the mesh file or sample has no use for:
    /// --unshare-instances and a further set of texture coordinates of what is no glTF, and a
    /// choice by names that the format does not have.
    void check(const std::string& path) const;
    /// Reads the mesh file or sample ("sample:teapot"), turns and scales it by the frame, and
    /// prints the reader's notes on stderr. Throws Error as read_mesh and check() do, and usage for
    /// a pattern that fits no name of the file, and for a set of texture coordinates that it does
    /// not have.
    Mesh load(const std::string& path) const;
    /// The pose of the mesh that load() gives (app/surface/sample_meshes.h), in its frame.
    MeshPose pose(const std::string& mesh, const std::string& pose) const;
};

/// Adds --pose (app/surface/sample_meshes.h).
void add_pose(CLI::App& verb, std::string& pose);

/// A validator of numbers within bounds that, unlike CLI::Range, refuses NaN.
CLI::Validator in_range(double low, double high);
/// A validator of words; its message suggests the nearest word for a misspelt one.
CLI::Validator one_of(const std::vector<std::string>& words);

/// Adds --threads, 0 for all.
void add_threads(CLI::App& verb, int& threads);
/// Adds --progress, a word of progress_modes (app/base/progress.h).
void add_progress(CLI::App& verb, std::string& mode);
/// Options about computations that a texture may leave out or reuse: --no-skip and --cache.
struct EconomyOptions {
    std::vector<std::string> forbidden;     ///< words of skip_names, or "all"
    std::optional<double> cache_megabytes;  ///< --cache, in units of 1024^2 bytes

    /// Adds --no-skip.
    void add_skips(CLI::App& verb);
    /// Adds --cache.
    void add_cache(CLI::App& verb);

    Skips skips() const;
    /// The cache size in bytes: the value of --cache, or else 1 GiB where `several` textures of one
    /// atlas will be made and 0 for a single one.
    std::size_t cache_bytes(bool several) const;
};

}  // namespace burl
