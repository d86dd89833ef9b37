// The recipes of a picture's mesh and planes, with the edits and moves that name them.
#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "app/direct/picture.h"
#include "app/options/idle_options.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

/// The keys without effect on a picture that is drawn without an atlas.
constexpr std::array idle_keys{
    IdleKey{"atlas", "--direct draws without an atlas"},
    IdleKey{"paint", "--direct draws the texture below the paint"},
    IdleKey{"filter.kind", "--direct takes its filter from --filter"},
    IdleKey{"filter.samples", "--direct takes its filter from --filter"}};

/// The recipes that a picture shows, by name, each with its edits and moves.
class ShownRecipes {
  public:
    explicit ShownRecipes(const DirectOptions& options) : options_(options) {
        for (const std::string& text : options.planes) names_.push_back(parse_plane(text).recipe);
        const bool bare = std::ranges::find(names_, "") != names_.end();
        if (!options.scene.empty() || bare || names_.empty()) add("");
        for (const std::string& name : names_) add(name);
    }

    /// The recipes, each with the edits and moves that name it. Throws Error(usage) for one that
    /// names no shown recipe.
    std::vector<MovedRecipe> with_edits(const AnimationOptions& animation) const {
        std::vector<MovedRecipe> result = recipes_;
        for (const std::string& text : options_.recipe.settings)
            give("--set", text, [&](std::size_t i, const std::string& edit) {
                result[i].options.settings.push_back(edit);
            });
        for (const std::string& text : animation.keys)
            give("--animate", text,
                 [&](std::size_t i, const std::string& key) { result[i].keys.push_back(key); });
        return result;
    }

    /// The picture's recipes, from recipes in the order of with_edits().
    PictureRecipes picture(const std::vector<Recipe>& recipes) const {
        PictureRecipes result;
        const std::size_t main = place_of("");
        if (main < recipes.size()) result.main = recipes[main];
        for (const std::string& name : names_) {
            result.planes.emplace_back();
            if (!name.empty()) result.planes.back() = recipes[place_of(name)];
        }
        return result;
    }

  private:
    /// Adds a name that is new; the empty name is that of --recipe.
    void add(const std::string& name) {
        if (place_of(name) < shown_.size()) return;
        shown_.push_back(name);
        recipes_.push_back({options_.recipe, {}});
        recipes_.back().options.settings.clear();
        if (!name.empty()) recipes_.back().options.recipe = name;
    }
    std::size_t place_of(const std::string& name) const {
        return std::size_t(std::ranges::find(shown_, name) - shown_.begin());
    }

    template <class Give>
    void give(const char* option, const std::string& text, const Give& give_to) const {
        const std::size_t colon = text.substr(0, text.find('=')).rfind(':');
        const bool named = colon != std::string::npos;
        const std::string name = named ? text.substr(0, colon) : "";
        bool given = false;
        for (std::size_t i = 0; i < shown_.size(); ++i) {
            const bool by_name = named && recipes_[i].options.recipe == name;
            if (!by_name && (named || !shown_[i].empty())) continue;
            give_to(i, named ? text.substr(colon + 1) : text);
            given = true;
        }
        if (!given) throw nothing_shows(option, text, name);
    }
    Error nothing_shows(const char* option, const std::string& text,
                        const std::string& name) const {
        std::vector<std::string> names;
        for (const MovedRecipe& one : recipes_) names.push_back(one.options.recipe);
        return Error(
            ExitCode::usage,
            fmt::format("{} {}: the picture does not show {}; name the recipe that "
                        "changes, as in {} {}:PATH=... (there are {})",
                        option, text, name.empty() ? "the recipe of --recipe" : "a recipe " + name,
                        option, names.front(), fmt::join(names, ", ")));
    }

    const DirectOptions& options_;
    std::vector<std::string> names_;  ///< per plane its recipe's name; empty: that of --recipe
    std::vector<std::string> shown_;  ///< the distinct names
    std::vector<MovedRecipe> recipes_;
};

}  // namespace

std::vector<PictureRecipes> picture_recipes(const DirectOptions& options,
                                            const AnimationOptions& animation) {
    const ShownRecipes shown(options);
    const std::vector<MovedRecipe> recipes = shown.with_edits(animation);
    for (const MovedRecipe& recipe : recipes) {
        refuse_edits(recipe.options, idle_keys, recipe.keys);
        if (options.pose.empty()) refuse_edits(recipe.options, {&idle_pose, 1}, recipe.keys);
    }
    const std::vector<std::vector<Recipe>> frames = frame_recipes(recipes, animation);
    for (std::size_t i = 0; i < recipes.size(); ++i)
        check_edits(recipes[i].options, frames[0][i], recipes[i].keys);
    std::vector<PictureRecipes> pictures;
    for (const std::vector<Recipe>& frame : frames) pictures.push_back(shown.picture(frame));
    return pictures;
}

}  // namespace burl
