#include "app/recipe/edit/places.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "app/recipe/edit/leaves.h"
#include "app/recipe/schema_check.h"
#include "app/recipe/spelling.h"

namespace burl {

namespace {

constexpr std::string_view constant_key = ".value";

class PlaceList {
  public:
    void add(const std::string& path, const Json& value,
             const std::shared_ptr<const Parameter>& parameter) {
        if (!value.is_number() && !is_color_text(value)) return;
        if (known_.insert(path).second) places.push_back({path, value, parameter});
    }

    void add_leaf(const RecipeLeaf& leaf) {
        if (!leaf.value.is_array()) return add(leaf.path, leaf.value, leaf.parameter);
        for (std::size_t i = 0; i < leaf.value.size(); ++i)
            add(fmt::format("{}.{}", leaf.path, i), leaf.value[i], leaf.parameter);
    }

    /// Adds what the JSON has at the path and below it, but for what is known already.
    void add_written(const Json& value, const std::string& path) {
        if (!value.is_structured()) return add(path, value, parameter_of(path));
        for (const auto& [key, item] : value.items()) add_written(item, join_path(path, key));
    }

    std::vector<RecipePlace> places;

  private:
    /// The entry of a stop's position; null for anything else.
    static std::shared_ptr<const Parameter> parameter_of(const std::string& path) {
        const auto parts = split_path(path);
        const bool stop = parts.size() > 3 && parts[parts.size() - 3] == "stops";
        if (!stop || parts.back() != "0") return {};
        // The table is static, so the pointer owns nothing.
        return {std::shared_ptr<void>(), find_parameter("texture.stops.0.0")};
    }

    std::set<std::string> known_;
};

}  // namespace

bool is_color_text(const Json& value) {
    return value.is_string() && value.get_ref<const std::string&>().starts_with('#');
}

std::vector<RecipePlace> recipe_places(const Json& recipe) {
    PlaceList list;
    for (const RecipeLeaf& leaf : recipe_leaves(recipe)) list.add_leaf(leaf);
    for (const auto& [key, value] : recipe.items()) {
        const bool part = key == "define" || key == "texture" || key == "material" || key == "bump";
        if (part) list.add_written(value, key);
    }
    return std::move(list.places);
}

const RecipePlace* find_place(const std::vector<RecipePlace>& places, const std::string& path) {
    const std::string one = respelled_path(path);
    std::vector<std::string> paths{one, one + std::string(constant_key)};
    if (one.ends_with(constant_key))
        paths.push_back(one.substr(0, one.size() - constant_key.size()));
    for (const std::string& candidate : paths) {
        const auto found = std::ranges::find(places, candidate, &RecipePlace::path);
        if (found != places.end()) return &*found;
    }
    return nullptr;
}

}  // namespace burl
