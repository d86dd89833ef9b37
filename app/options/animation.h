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
    /// Whether something else than a recipe moves, a camera, so that recipes may stand still.
    bool recipes_may_rest = false;

    /// Adds the options to the verb, which has --time already.
    void add(CLI::App& verb);
    bool asked() const { return frames > 0; }
};

/// The largest number of frames.
inline constexpr int most_frames = 9999;

/// A number that changes linearly from the first frame to the last.
struct NumberMove {
    std::string said;  ///< the text of --animate
    std::string path;  ///< the path of one number, such as "texture.input.noise.0.phase.2"
    double from = 0.0, to = 0.0;
    bool whole = false;  ///< whether the number is an integer: values are rounded
};

/// Parses "PATH=FROM:TO". Throws Error(usage) unless FROM and TO are finite numbers; any path is
/// taken.
NumberMove parse_move(const std::string& text);

/// The number at frame i of n (from 0): FROM in the first and TO in the last, in a loop in the one
/// after it.
double value_at(const NumberMove& move, int i, int n, bool loop);

/// The recipe of every frame, with the options' own edits applied first; a single recipe without
/// --frames. A number of --animate is FROM in the first frame and TO in the last, in a loop in the
/// one after it. A --time holds recipes with keys still, which is for frames that something else
/// moves. Throws Error as load_recipe does, naming --animate, before any frame is made, and
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
