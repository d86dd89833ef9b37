#pragma once
// Recipes: what texture a mesh is carved from. Their JSON is docs/reference/recipes.md.
#include <memory>
#include <string>
#include <vector>

#include "app/library/error.h"

namespace burl::library {

/// A recipe, which does not change: set() and at() give another one. Copies share their content.
/// Any number of threads may use a recipe at once.
class BURL_API Recipe {
  public:
    /// Loads the preset or material of that name ("oak"), or the file (.json, .mtlx). Throws Error:
    /// usage for an unknown name, io when the file cannot be read, invalid_file when it is no
    /// recipe.
    static Recipe load(const std::string& path_or_preset);
    /// Parses a recipe's JSON. `origin` names it in messages, and paths of images are relative to
    /// its folder. Throws Error(invalid_file) that names the line or the key.
    static Recipe parse(const std::string& json, const std::string& origin = "recipe");
    /// The names of all presets and materials that the library brings along.
    static std::vector<std::string> names();

    /// The recipe's name, such as "Oak"; may be empty.
    const std::string& name() const;
    /// The recipe as JSON, which parse() reads back to an equal recipe.
    std::string to_json() const;
    /// The recipe with one value changed: a dotted path such as "texture.input.noise.0.amplitude"
    /// or "atlas.size", or the name of one of its controls, in the spelling of `burl bake --set`.
    /// Throws Error(usage) that names the nearest path, or the range of the value.
    Recipe set(const std::string& path, const std::string& value) const;
    /// The recipe with one number changed, as set() does with its shortest text.
    Recipe set(const std::string& path, double value) const;
    /// The recipe at a time in seconds, without keys; a recipe without keys stays as it is. bake()
    /// and evaluate() take a recipe with keys at 0 s. Throws Error(usage) where the keys make no
    /// valid recipe at that time, and where `seconds` is not finite.
    Recipe at(double seconds) const;
    /// Sentences on what the recipe's file says and no recipe holds (MaterialX alone has such).
    std::vector<std::string> notes() const;

    /// The library's own representation.
    struct State;
    /// The library's own representation.
    const State& state() const { return *state_; }

  private:
    explicit Recipe(std::shared_ptr<const State> state);
    std::shared_ptr<const State> state_;
};

}  // namespace burl::library
