#pragma once
// Frames of an animation: --frames N of a recipe that has keys (app/recipe/keyed_recipe.h), or of
// numbers that --animate PATH=FROM:TO moves; the recipe and the file name of every frame. The mesh,
// its atlas and its solid points are those of all frames.
#include <span>
#include <string>
#include <vector>

#include "app/options/command_options.h"

namespace burl {

/// A number that goes linearly from the first frame to the last.
struct Key {
    std::string path;  ///< of one number, such as "texture.input.noise.0.phase.2"
    double from = 0.0, to = 0.0;
    bool whole = false;  ///< an integer parameter: rounded to the nearest
};

struct AnimationOptions {
    std::vector<std::string> keys;
    int frames = 0;
    bool loop = false;

    /// --animate, --frames and --loop.
    void add(CLI::App& verb);
    bool asked() const { return frames > 0; }
};

/// Parses "PATH=FROM:TO". Throws Error(usage) unless PATH is one number of a recipe outside its
/// atlas and FROM and TO are finite numbers.
Key parse_key(const std::string& text);

/// What the key is at frame i of n (from 0): FROM at the first one, TO at the last, exactly; in a
/// loop TO is where frame n would be.
double value_at(const Key& key, int i, int n, bool loop);

/// The recipe of every frame, with the options' own edits made first; without --frames the one that
/// there is. Throws Error as load_recipe does, naming --animate, before any frame is made; usage
/// where nothing changes over time.
std::vector<Recipe> frame_recipes(const RecipeOptions& options, const AnimationOptions& animation);

/// One of several recipes that a picture shows together.
struct MovedRecipe {
    RecipeOptions options;
    std::vector<std::string> keys;  ///< those of --animate that are its own
};

/// The recipes of every frame, each in their order. Recipes with keys share one clock:
/// the frames are spread over the time of the one that takes longest. `animation`: --frames and
/// --loop. Throws Error as the other one does.
std::vector<std::vector<Recipe>> frame_recipes(std::span<const MovedRecipe> recipes,
                                               const AnimationOptions& animation);

/// "out.png" is numbered from 1 on: "out.0001.png".
std::string frame_path(const std::string& out_path, std::size_t number);

/// The paths of all frames; without animation the one that is named.
std::vector<std::string> frame_paths(const std::string& out_path,
                                     const AnimationOptions& animation);

}  // namespace burl
