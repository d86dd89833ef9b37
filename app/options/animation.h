#pragma once
// Frames of an animation: the recipe and the file name of every frame. --frames N samples the keys
// of a recipe (app/recipe/edit/keyed_recipe.h), the numbers that --animate PATH=FROM:TO moves, or
// both. All frames share the mesh, its atlas and its solid points.
#include <span>
#include <string>
#include <vector>

#include "app/options/command_options.h"

namespace burl {

/// The options --animate, --frames and --loop.
struct AnimationOptions {
    std::vector<std::string> keys;
    int frames = 0;
    bool loop = false;

    /// Adds the options to the verb, which has --time already.
    void add(CLI::App& verb);
    bool asked() const { return frames > 0; }
};

/// The recipe of every frame, with the options' own edits applied first; a single recipe without
/// --frames. A number of --animate is FROM in the first frame and TO in the last, in a loop in the
/// one after it. Throws Error as load_recipe does, naming --animate, before any frame is made, and
/// Error(usage) where nothing changes over time.
std::vector<Recipe> frame_recipes(const RecipeOptions& options, const AnimationOptions& animation);

/// One of several recipes that a picture shows together.
struct MovedRecipe {
    RecipeOptions options;
    std::vector<std::string> keys;  ///< the texts of --animate that apply to this recipe
};

/// For every frame the recipes in the given order. Recipes with keys share one clock: the frames
/// are spread over the longest of their animations. `animation` gives --frames and --loop. Throws
/// Error as frame_recipes of a single recipe does, and usage for a --time where no recipe has keys.
std::vector<std::vector<Recipe>> frame_recipes(std::span<const MovedRecipe> recipes,
                                               const AnimationOptions& animation);

/// The path of the frame with this number, which counts from 1: "out.0001.png" for "out.png".
std::string frame_path(const std::string& out_path, std::size_t number);

/// The paths of all frames; `out_path` alone without --frames.
std::vector<std::string> frame_paths(const std::string& out_path,
                                     const AnimationOptions& animation);

}  // namespace burl
